// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/build_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "eye/anatomy.hpp"
#include "eye/anterior_capsule.hpp"
#include "eye/empty_bag.hpp"
#include "eye/implant.hpp"
#include "eye/make_eye.hpp"
#include "eye/posterior_capsule.hpp"
#include "math/turn.hpp"
#include "session/settings.hpp"
#include "tools/injector.hpp"
#include "tools/instruments.hpp"

namespace rhexis {
namespace {

void set_up_bag(BagModel& bag, const std::map<std::string, double>& settings) {
    bag.opening_radius = 0.5 * settings.at("capsulorhexis.diameter_mm");
    for (ZonuleSpring& zonule : bag.zonules) {
        zonule.stiffness *= settings.at("zonules.strength");
    }
}

/// The zonules of meridians within the arc that is lost at the start; they are numbered against the clock from +x.
ZonuleModel make_zonules(const std::map<std::string, double>& settings, const BagModel& bag, const EyeAnatomy& eye) {
    ZonuleModel zonules;
    zonules.breaks_at *= settings.at("zonules.toughness");
    zonules.rest_stretch *= settings.at("zonules.tension");
    zonules.limbus_radius = eye.limbus_radius;
    zonules.limbus_z = eye.limbus_z;
    const std::size_t meridians = bag.zonules.size() / 2;
    const double apart = 360.0 / static_cast<double>(meridians);
    const auto first = static_cast<std::size_t>(std::lround(settings.at("zonules.lost_from_deg") / apart));
    const auto count = static_cast<std::size_t>(std::lround(settings.at("zonules.lost_deg") / apart));
    zonules.lost.assign(bag.zonules.size(), 0);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t meridian = (first + i) % meridians;
        zonules.lost[2 * meridian] = 1;
        zonules.lost[2 * meridian + 1] = 1;
    }
    return zonules;
}

constexpr double vitreous_stiffness =
    1.5e5;                                 ///< below A^2 / C, 3.6e5, of a wall that gives way to it [uN/mm]. Proposal
constexpr double cortex_adhesion = 300.0;  ///< [Pa]. Proposal: no tool can turn a lens that adheres all round
constexpr double cortex_film = 2.0;  ///< [Pa]. Proposal: a tool turns the lens with ease, and it stays where it is

/// Hydrodissection has freed the cortex over a part of the meridians.
std::vector<std::uint8_t> adherent_nodes(const SolidModel& lens, double freed) {
    if (freed >= 1.0) {
        return {};
    }
    std::vector<std::uint8_t> adherent;
    for (const Vec3& node : lens.coarse.nodes) {
        adherent.push_back(share_of_turn(node) >= freed ? 1 : 0);
    }
    return adherent;
}

ChamberModel make_chamber(const std::map<std::string, double>& settings) {
    ChamberModel chamber;
    chamber.tube_compliance = settings.at("machine.tubing_mm3_mmhg") / pascal_per_mmhg;
    chamber.leak_conductance = settings.at("wound.leak_ml_min") * mm3_s_per_ml_min / (55.0 * pascal_per_mmhg);
    return chamber;
}

/// The ball of the cornea's back holds lens and angle of the chamber too.
DomeModel inner_wall(const EyeAnatomy& anatomy) {
    DomeModel dome;
    dome.radius = anatomy.cornea_back_radius;
    dome.centre.z() = anatomy.cornea_apex_z - anatomy.cornea_thickness - dome.radius;
    return dome;
}

IrisModel make_iris(const EyeAnatomy& anatomy) {
    IrisModel iris;
    iris.rest_z = anatomy.iris_z;
    iris.pupil_radius = anatomy.pupil_radius;
    iris.root_radius = anatomy.limbus_radius;
    iris.thickness = anatomy.iris_thickness;
    return iris;
}

/// Stable step that the lens is given the inertia for, whatever its mesh, cuts and hardness. The lens moves slowly, so
/// what it does under a tool stays (docs/accuracy.md) [s].
constexpr double lens_step = 5e-4;

/// The way the scene asks for, or substeps; each with elements it can step. In contact an implicit step of the lens
/// costs more than all the substeps of its time (docs/accuracy.md).
void set_up_lens(SolidModel& lens, Advance asked, bool by_points) {
    const bool implicit = asked == Advance::implicit;
    lens.by_points = by_points && !implicit;
    lens.advance = implicit ? Advance::implicit : Advance::explicit_;
    lens.sought_step = implicit ? 0.0 : lens_step;
    lens.formulation = implicit ? Formulation::linear : Formulation::nodal_pressure;
}

AnteriorCapsuleSettings capsule_settings(const std::map<std::string, double>& settings) {
    AnteriorCapsuleSettings capsule;
    capsule.triangles = static_cast<int>(settings.at("capsule.triangles"));
    capsule.circles = settings.at("capsule.fibres") >= 0.5;
    capsule.toughness = settings.at("capsule.toughness");
    capsule.zonule_tension = settings.at("zonules.tension");
    return capsule;
}

EmptyBagSettings empty_bag_settings(const SceneDescription& scene) {
    const std::map<std::string, double> settings = all_settings(scene);
    EmptyBagSettings bag;
    bag.opening = scene.opening;
    bag.triangles = static_cast<int>(settings.at("bag.triangles"));
    bag.opening_radius = 0.5 * settings.at("capsulorhexis.diameter_mm");
    bag.friction = settings.at("bag.friction");
    bag.rim_strength = settings.at("capsule.strength");
    return bag;
}

ViscoelasticModel make_viscoelastic(const std::map<std::string, double>& settings, const EyeModel& eye) {
    const HalfEllipsoids lens = lens_shape(eye.patient);
    ViscoelasticModel chamber;
    chamber.start_fill = settings.at("viscoelastic.fill");
    chamber.leak = settings.at("viscoelastic.leak");
    chamber.vitreous_pressure = settings.at("vitreous.pressure_mmhg") * pascal_per_mmhg;
    chamber.area = std::numbers::pi * lens.radius * lens.radius;
    chamber.inner_radius = eye.anatomy.limbus_radius;
    return chamber;
}

/// The margins lie on the eye a little under the limbus.
LidsModel make_lids(const EyeAnatomy& eye) {
    LidsModel lids;
    lids.height = eye.limbus_z - 0.4;
    lids.air_z = eye.cornea_apex_z + 1.0;
    lids.infusion_resistance = ChamberModel{}.infusion_resistance;
    return lids;
}

/// Around the tray in the middle, in the order in which a right hand takes them.
BeadsModel make_beads(const std::map<std::string, double>& settings, const EyeAnatomy& eye) {
    BeadsModel beads;
    beads.floor = eye.iris_z + 0.6;
    beads.target = Vec3(0.0, 0.0, beads.floor);
    const std::array<Vec2, 6> places{Vec2(2.2, 0.0), Vec2(-2.2, 0.0), Vec2(0.0, 2.2),
                                     Vec2(1.6, 1.6), Vec2(-1.6, 1.6), Vec2(0.0, -2.0)};
    const auto count = static_cast<std::size_t>(settings.at("beads.count"));
    for (std::size_t i = 0; i < count; ++i) {
        beads.start.emplace_back(places[i].x(), places[i].y(), beads.floor);
    }
    return beads;
}

MicroscopeModel make_microscope(const std::map<std::string, double>& settings, const EyeAnatomy& eye) {
    MicroscopeModel microscope;
    microscope.field_radius = 0.5 * settings.at("microscope.field_mm");
    microscope.depth_of_field = settings.at("microscope.depth_of_field_mm");
    microscope.start = Vec3(settings.at("microscope.x_mm"), settings.at("microscope.y_mm"),
                            eye.iris_z + settings.at("microscope.focus_mm"));
    return microscope;
}

/// A hole that an operation left.
void open_capsule(const std::map<std::string, double>& settings, const BagShape& bag, CapsuleModel& capsule) {
    capsule.start_hole = 0.5 * settings.at("capsule.hole_mm");
    const double x = settings.at("capsule.hole_x_mm");
    const double y = settings.at("capsule.hole_y_mm");
    const double share = (x * x + y * y) / (bag.radius * bag.radius);
    capsule.start_hole_place = Vec3(x, y, -bag.posterior * std::sqrt(std::max(0.0, 1.0 - share)));
}

/// Of a tear's edge that vitreous lies against [mm/s]: slower than without. Proposal
constexpr double backed_tear_speed = 0.4;

VitreousModel make_vitreous(const std::map<std::string, double>& settings, const EyeAnatomy& eye) {
    VitreousModel vitreous;
    vitreous.push = settings.at("vitreous.push_mmhg") * pascal_per_mmhg;
    vitreous.hyaloid_strength *= settings.at("vitreous.hyaloid");
    vitreous.wound = eye.incision;
    vitreous.start_front = settings.at("vitreous.front_mm3");
    vitreous.start_wound = settings.at("vitreous.wound_mm3");
    vitreous.start_marked = settings.at("vitreous.marked");
    vitreous.start_fill = settings.at("tamponade.fill");
    return vitreous;
}

GlobeModel make_globe(const EyeAnatomy& eye) {
    GlobeModel globe;
    const double rise = std::sqrt(eye.globe_radius * eye.globe_radius - eye.limbus_radius * eye.limbus_radius);
    globe.centre.z() = eye.limbus_z - rise;
    globe.front_radius = eye.cornea_radius;
    globe.front_centre.z() = eye.cornea_apex_z - eye.cornea_radius;
    globe.lips = {eye.incision, eye.side_port};
    globe.widths = {eye.incision_width, eye.side_port_width};
    return globe;
}

/// For what lies in the bag; the grids are cut as wide as it is.
HydrodissectionModel make_hydrodissection(const std::map<std::string, double>& settings, const SolidModel& lens,
                                          const BagModel& bag) {
    HydrodissectionModel model;
    model.cells.radius = bag.shape.radius;
    model.opening_radius = bag.opening_radius;
    model.seal *= bag.opening_radius / 2.625;
    model.start_fill = settings.at("hydrodissection.viscoelastic_fill");
    model.start_cleaved = settings.at("hydrodissection.freed");
    for (const Vec3& node : lens.coarse.nodes) {
        model.cell_of_node.push_back(cell_at(model.cells, node.head<2>()));
    }
    return model;
}

CortexModel make_cortex(const std::map<std::string, double>& settings, const BagShape& bag) {
    CortexModel model;
    model.cells.radius = bag.radius;
    model.adhesion *= settings.at("cortex.adhesion");
    model.start_left = settings.at("cortex.left");
    return model;
}

RetainedViscoelasticModel make_retained(const std::map<std::string, double>& settings) {
    RetainedViscoelasticModel model;
    model.start_front = settings.at("viscoelastic.front_mm3");
    model.start_behind = settings.at("viscoelastic.behind_mm3");
    model.start_angle = settings.at("viscoelastic.angle_mm3");
    return model;
}

constexpr double side_port_width = 1.0;  // [mm]
constexpr double side_port_inset = 1.5;  // [mm]

/// Of the side port, across the view.
Vec2 side_port_direction(const EyeAnatomy& eye, double angle) {
    if (angle == 80.0) {
        return eye.side_port.head<2>().normalized();
    }
    const Vec2 turned = direction_at(std::numbers::pi / 180.0 * angle);
    return {-turned.y(), -turned.x()};
}

WoundsModel make_wounds(const std::map<std::string, double>& settings, const EyeAnatomy& eye, const Patient& patient) {
    const HalfEllipsoids lens = lens_shape(patient);
    WoundsModel wounds;
    wounds.front_radius = eye.cornea_radius;
    wounds.front_centre.z() = eye.cornea_apex_z - eye.cornea_radius;
    wounds.back_radius = eye.cornea_back_radius;
    wounds.back_centre.z() = eye.cornea_apex_z - eye.cornea_thickness - eye.cornea_back_radius;
    wounds.limbus_radius = eye.limbus_radius;
    wounds.iris_z = eye.iris_z + 0.5 * eye.iris_thickness;
    wounds.pupil_radius = eye.pupil_radius;
    wounds.lens_radius = lens.radius;
    wounds.lens_front = lens.anterior;
    wounds.start_burn = settings.at("wounds.main_burn");
    Wound& main = wounds.start[main_wound];
    Wound& side = wounds.start[rhexis::side_port];
    main = made_wound(wounds, Vec2(0.0, -1.0), settings.at("wounds.main_tunnel_mm"),
                      settings.at("wounds.main_width_mm"), settings.at("wounds.main_inner_lip_mm"));
    main.peel = main.most_peel = settings.at("wounds.main_peel_mm");
    side = made_wound(wounds, side_port_direction(eye, settings.at("side_port.angle_deg")),
                      settings.at("wounds.side_tunnel_mm"), settings.at("wounds.side_width_mm"), side_port_inset);
    // Where it is to be cut, an uncut wound has its lips.
    main.begun = main.cut = settings.at("wounds.uncut") < 0.5;
    side.begun = side.cut = settings.at("wounds.uncut") < 1.5;
    return wounds;
}

bool has_instrument(const SceneDescription& scene, const std::string& name) {
    return std::find(scene.instruments.begin(), scene.instruments.end(), name) != scene.instruments.end();
}

bool needs_side_port(const SceneDescription& scene) {
    return has_instrument(scene, "spatula") || has_instrument(scene, "hook") || has_instrument(scene, "capsule_hook") ||
           has_tissue(scene, "vitreous");
}

/// Of viscoelastic that an implant shears some ten times a second [Pa s]: a hundredth and less of that at rest.
/// Proposal
constexpr double sheared_viscosity = 10.0;

/// Free where an injector brings it in.
ShellModel make_shell(const SceneDescription& scene) {
    const std::map<std::string, double> settings = all_settings(scene);
    const ImplantShape shape = implant_shape(settings);
    ShellModel model = injects(scene) ? free_implant(shape) : acrylic_implant(shape);
    model.material.young_modulus = 1e6 * settings.at("implant.modulus_mpa");
    model.tack = 1e3 * settings.at("implant.tackiness_kpa");
    if (has_tissue(scene, "viscoelastic")) {
        model.drag = disc_drag(sheared_viscosity, 0.5 * shape.optic_diameter);
    }
    return model;
}

}  // namespace

ImplantShape implant_shape(const std::map<std::string, double>& settings) {
    ImplantShape shape;
    shape.centre_thickness = settings.at("implant.centre_mm");
    shape.edge_thickness = settings.at("implant.edge_mm");
    shape.haptic_thickness = settings.at("implant.haptic_mm");
    shape.triangles = static_cast<int>(settings.at("implant.triangles"));
    return shape;
}

InjectorShape injector_shape(const std::map<std::string, double>& settings) {
    return {settings.at("cartridge.bore_mm"),         settings.at("cartridge.nozzle_mm"),
            settings.at("cartridge.friction"),        settings.at("cartridge.tucked") >= 0.5,
            settings.at("cartridge.inverted") >= 0.5, settings.at("injector.push_n")};
}

std::map<std::string, double> all_settings(const SceneDescription& scene) {
    std::map<std::string, double> settings;
    for (const SettingInfo& info : setting_table()) {
        settings[std::string(info.name)] = info.standard;
    }
    for (const auto& [name, value] : scene.settings) {
        settings[name] = value;
    }
    return settings;
}

bool has_tissue(const SceneDescription& scene, const std::string& name) {
    return std::find(scene.tissues.begin(), scene.tissues.end(), name) != scene.tissues.end();
}

bool injects(const SceneDescription& scene) {
    return has_tissue(scene, "implant") && has_instrument(scene, injector_name);
}

Result<BuiltWorld> build_world(const SceneDescription& scene) {
    // a bag alone takes its damping from the lens that it was made for
    const bool solid_lens = has_tissue(scene, "lens") || (has_tissue(scene, "bag") && !has_tissue(scene, "implant"));
    Result<EyeModel> eye = make_eye(scene.patient, solid_lens);
    if (!eye) {
        return eye.error();
    }
    set_up_bag(eye.value().bag, all_settings(scene));
    set_up_lens(eye.value().lens, scene.advance, scene.lens_by_points);
    eye.value().anatomy.has_iris = has_tissue(scene, "iris");
    eye.value().anatomy.has_cornea = has_tissue(scene, "cornea");
    eye.value().anatomy.trypan_blue = all_settings(scene).at("capsule.trypan_blue");
    eye.value().anatomy.has_implant = all_settings(scene).at("implant.in_place") > 0.5;
    eye.value().anatomy.side_port_width = needs_side_port(scene) ? side_port_width : 0.0;
    std::shared_ptr<WorldModel> world = std::make_shared<WorldModel>();
    if (has_tissue(scene, "lens")) {
        world->solids.push_back(eye.value().lens);
    }
    if (has_tissue(scene, "bag") && has_tissue(scene, "implant")) {
        world->membranes.push_back(
            make_empty_bag(lens_shape(scene.patient), eye.value().bag, scene.patient.age, empty_bag_settings(scene)));
    } else if (has_tissue(scene, "bag")) {
        BagModel& bag = world->bags.emplace_back(eye.value().bag);
        if (has_tissue(scene, "lens")) {
            bag.film = cortex_film;
            bag.adhesion = cortex_adhesion;
            bag.adherent = adherent_nodes(eye.value().lens, all_settings(scene).at("hydrodissection.freed"));
        }
        bag.cushion = has_tissue(scene, "chamber") ? vitreous_stiffness : 0.0;
        if (has_tissue(scene, "zonules")) {
            bag.breakable = make_zonules(all_settings(scene), bag, eye.value().anatomy);
        }
    }
    if (has_tissue(scene, "chamber")) {
        world->chamber = make_chamber(all_settings(scene));
    }
    if ((has_tissue(scene, "chamber") || injects(scene)) && has_tissue(scene, "cornea")) {
        world->domes.push_back(inner_wall(eye.value().anatomy));
    }
    if (has_tissue(scene, "capsule")) {
        world->capsule = make_capsule(scene.patient.age);
        world->capsule->ultimate_strain *= all_settings(scene).at("capsule.strength");
        open_capsule(all_settings(scene), eye.value().bag.shape, *world->capsule);
    }
    if (has_tissue(scene, "vitreous")) {
        world->vitreous = make_vitreous(all_settings(scene), eye.value().anatomy);
        world->capsule->tear_speed = backed_tear_speed;
    }
    if (has_tissue(scene, "globe")) {
        world->globe = make_globe(eye.value().anatomy);
    }
    if (has_tissue(scene, "wounds")) {
        world->wounds = make_wounds(all_settings(scene), eye.value().anatomy, scene.patient);
    }
    if (has_tissue(scene, "hydrodissection")) {
        world->hydrodissection = make_hydrodissection(all_settings(scene), world->solids[0], world->bags[0]);
        world->bags[0].adherent.resize(world->solids[0].coarse.nodes.size(), 0);
    }
    if (has_tissue(scene, "cortex")) {
        world->cortex = make_cortex(all_settings(scene), eye.value().bag.shape);
    }
    if (has_tissue(scene, "retained_viscoelastic")) {
        world->retained = make_retained(all_settings(scene));
    }
    if (has_tissue(scene, "anterior_capsule")) {
        world->membranes.push_back(make_anterior_capsule(lens_shape(scene.patient), eye.value().bag, scene.patient.age,
                                                         capsule_settings(all_settings(scene))));
    }
    if (has_tissue(scene, "implant")) {
        world->shells.push_back(make_shell(scene));
        world->implant = implant_parts(implant_shape(all_settings(scene)));
    }
    if (has_tissue(scene, "viscoelastic")) {
        world->viscoelastic = make_viscoelastic(all_settings(scene), eye.value());
    }
    if (has_tissue(scene, "chamber") && has_tissue(scene, "iris")) {
        world->iris = make_iris(eye.value().anatomy);
        if (world->wounds) {
            world->prolapse = ProlapseModel{};
        }
    }
    if (has_tissue(scene, "lids")) {
        world->lids = make_lids(eye.value().anatomy);
    }
    if (has_tissue(scene, "beads")) {
        world->beads = make_beads(all_settings(scene), eye.value().anatomy);
    }
    for (const std::string& name : scene.instruments) {
        if (name == microscope_name) {
            world->microscope = make_microscope(all_settings(scene), eye.value().anatomy);
            continue;
        }
        Result<ToolModel> tool =
            name == injector_name ? injector(injector_shape(all_settings(scene))) : make_tool(name);
        if (!tool) {
            return tool.error();
        }
        world->tools.push_back(std::move(tool).value());
    }
    return BuiltWorld{std::move(eye).value(), std::move(world)};
}

}  // namespace rhexis
