// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/microscope_view.hpp"

#include <algorithm>
#include <numbers>

#include "math/roots.hpp"
#include "render/eye_balls.hpp"
#include "render/still_lens.hpp"

namespace rhexis {

namespace {

constexpr std::array part_names{"beyond the limbus", "iris", "edge of the pupil", "middle of the pupil"};

constexpr double softening_mm = 0.10;  ///< standard deviation: tissue scatters, and facets should not show
constexpr int area_margin = 10;        ///< [pixels] that smoothing reaches beyond the pupil

constexpr double sheet_margin = 0.6;  ///< beyond the pupil's edge that sheets are drawn [mm]

/// How far from an instrument its shadow falls. [mm]
constexpr int shadow_scale = 8;  ///< they are drawn at an eighth of the size
const Vec2 inner_shadow(0.28, -0.25);
const Vec2 outer_shadow(0.45, -0.45);

/// Where the shadow of what lies in a rectangle can show: see shadows.frag.
PixelRect shadow_of(const PixelRect& rect, const Vec2& shift_mm, const View& view) {
    constexpr double farthest = 1.5;  // of the shift
    constexpr double coarse = 1.5 * shadow_scale;
    const double mm = 1.0 / pixel_mm(view, Vec3::Zero());
    const Vec2 shift = mm * shift_mm;
    const double soft = std::abs(shift.y()) * std::max(1.0, double(view.width) / view.height) + coarse;
    const int left = static_cast<int>(std::floor(rect.x + shift.x() - soft));
    const int right = static_cast<int>(std::ceil(rect.x + rect.width + farthest * shift.x() + soft));
    const int low = static_cast<int>(std::floor(rect.y + farthest * shift.y() - soft));
    const int high = static_cast<int>(std::ceil(rect.y + rect.height + shift.y() + soft));
    return {left, low, right - left, high - low};
}

constexpr double film_jump_s = 0.25;   ///< of time, beyond which the tear film is drawn anew at once
constexpr std::size_t film_turns = 8;  ///< pictures, until all of it is

/// Centre of the pupil and its reach sideways and upwards, in pixels from the bottom left.
struct PupilOnScreen {
    Vec2 centre;
    Vec2 reach;
};

/// Through what the lens is seen: the pupil, or all that lies behind the limbus where there is no iris.
double opening_of(const EyeAnatomy& eye) { return eye.has_iris ? eye.pupil_radius : eye.limbus_radius; }

/// How near to the axis a wound shows. [mm]
double reach_of_wound(const EyeAnatomy& eye, const Vec3& inner_lip, double width) {
    return width > 0.0 ? 1.075 * inner_lip.head<2>().norm() - 0.35 : eye.limbus_radius;
}

constexpr std::size_t most_hooks = 5;    ///< that are drawn; as in the shader
constexpr std::size_t most_crumbs = 24;  ///< that are drawn; as in the shader

/// Likewise iris in the wound, which takes the edge along.
Vec3 prolapsed_edge(const Frame& frame) {
    constexpr double half = 1.5;  // length that draws half as far as any [mm]
    const double length = frame.prolapse ? frame.prolapse->length : 0.0;
    const Vec2 direction = frame.eye->incision.head<2>().normalized();
    return {direction.x(), direction.y(), -1.3 * length / (length + half)};
}

/// A strand in the wound holds the pupil's edge there, and the rest comes in: towards the wound, negative [mm].
Vec3 peaked_edge(const Frame& frame) {
    if (frame.prolapse && frame.prolapse->length > 0.0) {
        return prolapsed_edge(frame);
    }
    if (!frame.vitreous || !(frame.vitreous->wound > 0.0)) {
        return Vec3::Zero();
    }
    constexpr double half = 3.0;  // vitreous in the wound that draws half as far as any [mm^3]
    const double drawn = 1.1 * frame.vitreous->wound / (frame.vitreous->wound + half);
    const Vec2 direction = frame.eye->incision.head<2>().normalized();
    return {direction.x(), direction.y(), -drawn};
}

/// Where the pupil's edge is drawn into a mouth: its direction from the axis, and how far it has come from where it was
/// [mm]; 0: it is not; negative: see above.
Vec3 caught_edge(const Frame& frame) {
    if (!frame.iris || frame.iris->tool < 0) {
        return peaked_edge(frame);
    }
    const Vec2 edge = frame.iris->place.head<2>();
    const Vec2 mouth = frame.tools[frame.iris->tool].pose.position.head<2>();
    const Vec2 direction = edge.normalized();
    const double come = std::clamp(edge.norm() - direction.dot(mouth), 0.0, 2.0);
    return {direction.x(), direction.y(), come};
}

constexpr double most_flap = 3.5;  ///< of Descemet's membrane, that is drawn: more lies rolled up [mm]

/// How far Descemet's membrane hangs from a wound towards the axis. [mm]
double flap_of(const Frame& frame) {
    double flap = 0.0;
    if (frame.wounds) {
        for (const Wound& wound : frame.wounds->wounds) {
            flap = std::max(flap, std::min(wound.peel, most_flap));
        }
    }
    return flap;
}

/// Within this, at the iris, neither its edge nor a wound nor the limbus can show. [mm]
double core_radius(const Frame& frame) {
    const EyeAnatomy& eye = *frame.eye;
    const double magnified = 1.15;  // by the cornea, at most
    const double wound = std::min(reach_of_wound(eye, eye.incision, eye.incision_width),
                                  reach_of_wound(eye, eye.side_port, eye.side_port_width));
    const double clear = std::min(wound - flap_of(frame), eye.limbus_radius - 1.5) / magnified;
    return std::max(0.0, std::min(opening_of(eye) - 0.25 - std::abs(caught_edge(frame).z()), clear));
}

PupilOnScreen pupil_on_screen(const EyeAnatomy& eye, const View& inner) {
    const Vec3 middle(0.0, 0.0, eye.iris_z);
    PupilOnScreen pupil{pixel_of(inner, middle), Vec2::Zero()};
    const double radius = opening_of(eye);
    for (const Vec3& rim : {Vec3(radius, 0.0, 0.0), Vec3(0.0, radius, 0.0)}) {
        pupil.reach += (pixel_of(inner, middle + rim) - pupil.centre).cwiseAbs();
    }
    pupil.centre.y() = inner.height - pupil.centre.y();
    return pupil;
}

/// Where the coaxial light is half as bright as in the middle of its spot: a third wider than the cornea, as pictures
/// of operations have it, and as wide as the field where that is wider, as a lamp's field stop is opened. Proposals. It
/// goes with the microscope.
double half_of_spot(const View& view) {
    constexpr double least_mm = 7.75;
    constexpr double of_field = 0.51;
    return std::max(least_mm, of_field * view.height * pixel_mm(view, view.plane_point));
}

/// What comes back from the fundus fades beside the middle of the spot, as a bell. Proposal.
double lamp_share(const View& view) {
    const double beside = view.plane_point.head<2>().norm();
    return std::exp2(-(beside * beside) / (half_of_spot(view) * half_of_spot(view)));
}

void set_lamp(const Program& program, const View& outer) {
    program.set("lamp_spot", Vec3(outer.plane_point.x(), outer.plane_point.y(), half_of_spot(outer)));
}

void set_anatomy(const Program& program, const EyeAnatomy& eye) {
    program.set("cornea", cornea_ball(eye));
    program.set("globe", globe_ball(eye));
    program.set("limbus_radius", eye.limbus_radius);
    program.set("limbus_z", eye.limbus_z);
    program.set("iris_z", eye.iris_z);
    program.set("pupil_radius", opening_of(eye));
    program.set("has_iris", eye.has_iris ? 1 : 0);
    program.set("has_cornea", eye.has_cornea ? 1 : 0);
    program.set("sclera_extent", sclera_extent_mm);
    program.set("incision", eye.incision);
    program.set("incision_width", eye.incision_width);
    program.set("wound_burn", eye.wound_burn);
    program.set("side_port", eye.side_port);
    program.set("side_port_width", eye.side_port_width);
}

/// What shows of how wounds are shut, and of what comes out of them.
void set_wounds(const Program& program, const Frame& frame) {
    Vec2 swelling = Vec2::Zero();
    Vec2 fluid = Vec2::Zero();
    Vec2 peel = Vec2::Zero();
    Vec2 stitches = Vec2::Zero();
    if (frame.wounds) {
        constexpr double least = 0.05;  // on a lip, that shows [mm^3]
        constexpr double most = 0.9;    // radius of a film: more runs off [mm]
        const Wound& main = frame.wounds->wounds[main_wound];
        const Wound& side = frame.wounds->wounds[side_port];
        swelling = Vec2(main.cut ? main.swelling : 0.0, side.cut ? side.swelling : 0.0);
        fluid = Vec2(main.fluid > least ? std::min(most, 1.3 * ball_radius(main.fluid)) : 0.0,
                     side.fluid > least ? std::min(most, 1.3 * ball_radius(side.fluid)) : 0.0);
        peel = Vec2(std::min(main.peel, most_flap), std::min(side.peel, most_flap));
        stitches = Vec2(main.sutures, side.sutures);
    }
    program.set("wound_peel", peel);
    program.set("wound_stitches", stitches);
    program.set("wound_swelling", swelling);
    program.set("wound_fluid", fluid);
}

/// The ball that stands on the hole, and the strand from there to the wound.
void set_vitreous(const Program& program, const Frame& frame) {
    Eigen::Vector4d ball = Eigen::Vector4d::Zero();
    Eigen::Vector4d strand = Eigen::Vector4d::Zero();
    double white = 0.0;
    if (frame.vitreous && frame.capsule && !frame.bags.empty()) {
        const double radius = vitreous_radius(vitreous_in_front(*frame.vitreous));
        const Vec3 place = vitreous_place(*frame.model, frame.bags, *frame.capsule, *frame.vitreous);
        ball << place + radius * Vec3::UnitZ(), radius;
        strand << frame.eye->incision, frame.vitreous->wound > 0.0 ? vitreous_radius(frame.vitreous->wound) : 0.0;
        white = frame.vitreous->marked;
    }
    program.set("vitreous", ball);
    program.set("vitreous_strand", strand);
    program.set("vitreous_white", white);
}

/// What a posterior capsule that is held or open shows, an iris that is caught, and crumbs.
void set_harm(const Program& program, const Frame& frame) {
    Eigen::Vector4d folds = Eigen::Vector4d::Zero();
    Eigen::Vector4d hole = Eigen::Vector4d::Zero();
    if (frame.capsule && !frame.bags.empty()) {
        const Pose& bag = frame.bags[0].pose;
        folds << bag.to_world(frame.capsule->place), frame.capsule->captured ? 1.0 : 0.0;
        hole << bag.to_world(frame.capsule->hole_place), frame.capsule->hole_radius;
    }
    program.set("folds", folds);
    program.set("hole", hole);
    program.set("caught_edge", caught_edge(frame));
    Eigen::Vector4d prolapse = Eigen::Vector4d::Zero();
    if (frame.prolapse && frame.wounds && frame.prolapse->length > 0.1) {
        const Vec2 lip = frame.wounds->wounds[main_wound].inner.head<2>();
        prolapse << lip.normalized(), lip.norm(), frame.prolapse->length;
    }
    program.set("prolapse", prolapse);
    set_vitreous(program, frame);
    set_wounds(program, frame);
    const std::size_t crumbs = std::min(frame.debris.size(), most_crumbs);
    program.set("crumb_count", static_cast<int>(crumbs));
    program.set("crumbs_are_beads", frame.model->beads.has_value() ? 1 : 0);
    for (std::size_t i = 0; i < crumbs; ++i) {
        const Debris& crumb = frame.debris[i];
        Eigen::Vector4d ball;
        ball << crumb.position, radius_of(crumb);
        program.set(("crumbs[" + std::to_string(i) + "]").c_str(), ball);
    }
}

/// A ring that is on its way from its tube into the fornix of the bag.
void set_ring(const Program& program, const Frame& frame) {
    Eigen::Vector4d feed = Eigen::Vector4d::Zero();
    Eigen::Vector4d fornix = Eigen::Vector4d::Zero();
    const double in = frame.bags.empty() || !frame.bags[0].zonules ? 0.0 : frame.bags[0].zonules->ring;
    if (in > 0.0 && in < 1.0) {
        constexpr double inside = 0.26;  // of the bag's edge, the ring [mm]
        constexpr double bend = 0.9;     // round the fornix by which it has come to lie in it [rad]
        fornix << frame.bags[0].pose.position.head<2>(), frame.model->bags[0].shape.radius - inside, 0.0;
        for (std::size_t i = 0; i < frame.tools.size(); ++i) {
            if (frame.model->tools[i].kind == ToolKind::ring && frame.tools[i].present) {
                feed << frame.tools[i].pose.position.head<2>(), std::min(1.0, 4.0 * in) * bend, 1.0;
            }
        }
    }
    program.set("ring_feed", feed);
    program.set("fornix", fornix);
}

/// What shows of a bag whose zonules can break: its edge, a ring, and hooks.
void set_zonules(const Program& program, const Frame& frame) {
    const bool breakable = !frame.bags.empty() && frame.bags[0].zonules.has_value();
    program.set("ring_in", breakable && frame.bags[0].zonules->ring >= 1.0 ? 1.0 : 0.0);
    set_ring(program, frame);
    Eigen::Vector4d loose = Eigen::Vector4d::Zero();
    if (breakable) {
        constexpr double least_deg = 20.0;  // narrower gaps leave no slack that shows. Proposal
        const ZonuleGap gap = widest_gap(frame.model->bags[0], *frame.bags[0].zonules);
        if (gap.width_deg > least_deg) {
            loose << gap.middle.head<2>().normalized(), std::numbers::pi / 360.0 * gap.width_deg, 1.0;
        }
    }
    program.set("loose", loose);
    const std::size_t hooks = breakable ? std::min(frame.bags[0].zonules->hooks.size(), most_hooks) : 0;
    program.set("capsule_hook_count", static_cast<int>(hooks));
    for (std::size_t i = 0; i < hooks; ++i) {
        const CapsuleHook& hook = frame.bags[0].zonules->hooks[i];
        Eigen::Vector4d line;
        line << frame.bags[0].pose.to_world(hook.on_bag).head<2>(), hook.at_limbus.head<2>();
        program.set(("capsule_hooks[" + std::to_string(i) + "]").c_str(), line);
    }
}

/// Cortex on the wall, or where the wave of hydrodissection has been: one value per cell.
void set_bag_cells(const Program& program, const Frame& frame) {
    const bool cortex = frame.cortex.has_value() && frame.model->cortex.has_value();
    const bool wave = frame.hydrodissection.has_value() && frame.model->hydrodissection.has_value();
    const BagCells cells =
        cortex ? frame.model->cortex->cells : (wave ? frame.model->hydrodissection->cells : BagCells{0, 0, 1.0});
    program.set("bag_sectors", cells.sectors);
    program.set("bag_rings", cells.rings);
    program.set("cells_are_cortex", cortex ? 1 : 0);
    for (int sector = 0; sector < cells.sectors; ++sector) {
        Eigen::Vector4d rings = Eigen::Vector4d::Zero();
        for (int ring = 0; ring < cells.rings; ++ring) {
            const std::size_t cell = static_cast<std::size_t>(sector * cells.rings + ring);
            rings[ring] = cortex ? frame.cortex->volume[cell] / frame.model->cortex->volume
                                 : frame.hydrodissection->cleaved[cell];
        }
        program.set(("bag_cells[" + std::to_string(sector) + "]").c_str(), rings);
    }
}

/// An implant that is a disc only, and viscoelastic about it.
void set_optic(const Program& program, const Frame& frame) {
    Eigen::Vector4d optic = Eigen::Vector4d::Zero();
    Vec2 viscoelastic = Vec2::Zero();
    if (frame.retained && frame.model->retained && !frame.bags.empty()) {
        constexpr double much = 100.0;  // about the volume before the optic of a chamber that is full [mm^3]
        const RetainedViscoelasticModel& disc = *frame.model->retained;
        optic << frame.bags[0].pose.to_world(Vec3(0.0, 0.0, disc.optic_z)), disc.optic_radius;
        viscoelastic = Vec2(std::min(1.0, frame.retained->front / much),
                            std::min(1.0, frame.retained->behind / std::max(1e-9, disc.start_behind)));
    } else if (frame.eye->has_implant) {
        const Vec2 aside(0.14, -0.10);  // from the pupil's middle, as many lie. Proposal [mm]
        constexpr double behind = 1.1;  // the pupil [mm]
        constexpr double radius = 3.0;
        optic << aside, frame.eye->iris_z - behind, radius;
    }
    program.set("optic", optic);
    program.set("optic_mirrors", Vec2(11.0, 8.0));  // proposals: of an implant of 21 dioptres, steeper behind
    program.set("viscoelastic", viscoelastic);
    program.set("optic_rocked", frame.retained ? frame.retained->rocked : 0.0);
}

void set_bag(const Program& program, const Frame& frame) {
    program.set("has_bag", frame.bags.empty() ? 0 : 1);
    set_bag_cells(program, frame);
    set_optic(program, frame);
    if (!frame.bags.empty()) {
        const BagModel& bag = frame.model->bags[0];
        program.set("bag_from_world", Mat4(matrix_of(frame.bags[0].pose).inverse()));
        program.set("bag_shape", Vec3(bag.shape.radius, bag.shape.anterior, bag.shape.posterior));
        program.set("opening_radius", bag.opening_radius);
    }
    set_zonules(program, frame);
}

bool has_sheets(const Frame& frame) { return !frame.membranes.empty() || !frame.shells.empty(); }

bool has_crumbs(const Frame& frame) { return !frame.debris.empty(); }

/// Cortex or a wave: values in the bag's cells.
bool has_cells(const Frame& frame) {
    return (frame.cortex && frame.model->cortex) || (frame.hydrodissection && frame.model->hydrodissection);
}

/// A posterior capsule that is held or open, and vitreous.
bool has_harm(const Frame& frame) {
    const bool vitreous = frame.vitreous && (vitreous_in_front(*frame.vitreous) > 0.0 || frame.vitreous->wound > 0.0);
    return vitreous || (frame.capsule && (frame.capsule->captured || frame.capsule->hole_radius > 0.0));
}

bool has_optic(const Frame& frame) { return (frame.retained && frame.model->retained) || frame.eye->has_implant; }

bool has_zonules(const Frame& frame) { return !frame.bags.empty() && frame.bags[0].zonules; }

/// More than cuts that are shut.
bool has_wounds(const Frame& frame) {
    const auto shows = [](const Wound& wound) {
        return wound.swelling > 0.0 || wound.fluid > 0.0 || wound.peel > 0.0 || wound.sutures > 0;
    };
    return frame.eye->wound_burn > 0.0 ||
           (frame.wounds && std::any_of(frame.wounds->wounds.begin(), frame.wounds->wounds.end(), shows));
}

bool is_caught(const Frame& frame) {
    return caught_edge(frame).z() != 0.0 || (frame.prolapse && frame.prolapse->length > 0.0);
}

/// What a scene may show beyond a healthy eye.
struct Feature {
    const char* name;  ///< in the shaders
    bool (*shows)(const Frame& frame);
    bool beyond_pupil;  ///< it reaches beyond the edge of the pupil
};
constexpr std::array features{
    Feature{"SHEETS", has_sheets, false},  Feature{"CRACKS", has_cracks, false}, Feature{"CRUMBS", has_crumbs, false},
    Feature{"CELLS", has_cells, false},    Feature{"HARM", has_harm, false},     Feature{"OPTIC", has_optic, false},
    Feature{"ZONULES", has_zonules, true}, Feature{"WOUNDS", has_wounds, true},  Feature{"CAUGHT", is_caught, true}};

/// Bit i: the i-th shows.
unsigned features_of(const Frame& frame, bool in_pupil) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < features.size(); ++i) {
        if ((in_pupil || features[i].beyond_pupil) && features[i].shows(frame)) {
            bits |= 1U << i;
        }
    }
    return bits;
}

Result<ProgramVariants> build_part(int part) {
    std::vector<const char*> names;
    for (const Feature& feature : features) {
        names.push_back(feature.name);
    }
    return ProgramVariants::create({"part.vert"},
                                   {"view.glsl", "lamp.glsl", "eye_front.glsl", "bag_support.glsl", "microscope.frag"},
                                   std::move(names), "#define PART " + std::to_string(part) + "\n");
}

}  // namespace

EyeAreas eye_areas(const EyeAnatomy& eye, const View& outer, const View& inner) {
    EyeAreas areas;
    areas.cornea = united(rect_around_circle(outer, eye.limbus_radius + 0.5, eye.limbus_z, 2),
                          rect_around_circle(outer, 0.5 * eye.limbus_radius, eye.cornea_apex_z, 2));
    areas.pupil = rect_around_circle(inner, opening_of(eye) + 0.05, eye.iris_z, area_margin);
    // The pupil's part draws everything that the cornea's does, so it may reach beyond.
    areas.cornea = united(areas.cornea, areas.pupil);
    return areas;
}

Result<MicroscopeView::KeptLight> MicroscopeView::make_kept_light(int width, int height) {
    Result<ProgramVariants> write_white = build_part(4);
    Result<ProgramVariants> write_iris = build_part(5);
    Result<ProgramVariants> draw_white = build_part(6);
    Result<ProgramVariants> draw_iris = build_part(7);
    Result<ProgramVariants> draw_pupil = build_part(8);
    for (const Result<ProgramVariants>* program : {&write_white, &write_iris, &draw_white, &draw_iris, &draw_pupil}) {
        if (!program->ok()) {
            return program->error();
        }
    }
    return KeptLight{std::move(write_white).value(),
                     std::move(write_iris).value(),
                     {std::move(draw_white).value(), std::move(draw_iris).value(), std::move(draw_pupil).value()},
                     make_double_target(width, height, GL_RGBA16F, GL_NEAREST),
                     {},
                     {}};
}

Result<MicroscopeView> MicroscopeView::create(int width, int height, bool keeps_light) {
    Result<Program> light = Program::build({"fullscreen.vert"}, {"view.glsl", "pupil_light.frag"});
    Result<Program> soften = Program::build({"fullscreen.vert"}, {"soften.frag"});
    Result<Program> shadows = Program::build({"part.vert"}, {"shadows.frag"});
    Result<Program> card = Program::build({"fullscreen.vert"}, {"view.glsl", "lamp.glsl", "card.frag"});
    for (const Result<Program>* program : {&light, &soften, &shadows, &card}) {
        if (!program->ok()) {
            return program->error();
        }
    }
    Result<ProgramVariants> white = build_part(0);
    Result<ProgramVariants> iris = build_part(1);
    Result<ProgramVariants> edge = build_part(2);
    Result<ProgramVariants> middle = build_part(3);
    for (const Result<ProgramVariants>* program : {&white, &iris, &edge, &middle}) {
        if (!program->ok()) {
            return program->error();
        }
    }
    Result<EyePainter> painter = EyePainter::create();
    if (!painter.ok()) {
        return painter.error();
    }
    Result<LensFront> front = LensFront::create(width, height);
    if (!front.ok()) {
        return front.error();
    }
    Result<SheetLayer> sheets = SheetLayer::create(width, height);
    if (!sheets.ok()) {
        return sheets.error();
    }
    Result<CrackLayer> cracks = CrackLayer::create(width, height);
    if (!cracks.ok()) {
        return cracks.error();
    }
    std::optional<KeptLight> kept;
    if (keeps_light) {
        Result<KeptLight> made = make_kept_light(width, height);
        if (!made.ok()) {
            return made.error();
        }
        kept.emplace(std::move(made).value());
    }
    return MicroscopeView(
        Steps{std::move(light).value(), std::move(soften).value(), std::move(shadows).value(), std::move(card).value()},
        std::array<ProgramVariants, 4>{std::move(white).value(), std::move(iris).value(), std::move(edge).value(),
                                       std::move(middle).value()},
        std::move(kept), std::move(painter).value(), std::move(front).value(), std::move(sheets).value(),
        std::move(cracks).value(), width, height);
}

MicroscopeView::MicroscopeView(Steps steps, std::array<ProgramVariants, 4> parts, std::optional<KeptLight> kept,
                               EyePainter painter, LensFront front, SheetLayer sheets, CrackLayer cracks, int width,
                               int height)
    : steps_(std::move(steps)),
      parts_(std::move(parts)),
      kept_(std::move(kept)),
      eye_painter_(std::move(painter)),
      front_(std::move(front)),
      sheets_(std::move(sheets)),
      cracks_(std::move(cracks)),
      inside_(width, height),
      outside_(width, height),
      light_(make_single_target(1, 1, GL_RGBA32F, GL_NEAREST)),
      across_(make_single_target((width + 1) / 2, (height + 1) / 2, GL_RGBA16F, GL_NEAREST)),
      soft_(make_single_target((width + 1) / 2, (height + 1) / 2, GL_RGBA16F, GL_LINEAR)),
      shadows_(make_single_target((width + shadow_scale - 1) / shadow_scale, (height + shadow_scale - 1) / shadow_scale,
                                  GL_RGBA8, GL_LINEAR)),
      picture_(make_single_target(width, height, GL_RGBA16F, GL_LINEAR_MIPMAP_LINEAR)),
      tools_(width, height),
      disturbed_(width, height),
      painted_(width, height),
      rectangles_({2}) {
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    // Beyond the field's stop and where no instrument is nothing is painted, and it must be some light, not any bits.
    for (const Target* target : {&picture_, &shadows_}) {
        target->bind();
        glClear(GL_COLOR_BUFFER_BIT);
    }
}

void MicroscopeView::draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools,
                          const View& outer, const View& inner, const DepthPass& depth, const Texture& detail,
                          double stop_pixels, PassClock& clock) {
    const EyeAnatomy& eye = *frame.eye;
    const PaintedFor wanted{eye.limbus_radius, eye.has_iris, eye.has_cornea};
    if (!textures_ || painted_for_ != wanted) {
        textures_.emplace(eye_painter_.paint(eye));
        painted_for_ = wanted;
    }
    const EyeAreas areas = eye_areas(eye, outer, inner);
    front_.draw(frame, inner, depth.reference(), areas.pupil);
    clock.end("first surface of the lens");
    if (has_sheets(frame)) {
        sheets_.draw(frame, inner, depth.stop(), depth.reference(), contour_of(still_lens(frame)), detail, areas.pupil,
                     opening_of(eye) + sheet_margin);
        clock.end("sheets");
    }
    if (has_cracks(frame)) {
        cracks_.draw(frame, inner, depth.stop(), depth.reference(), areas.pupil);
        clock.end("cracks");
    }
    inside_.draw(painter, frame, tools, inner, Medium::inside, areas.cornea, eye, detail);
    clock.end("instruments inside");
    outside_.draw(painter, frame, tools, outer, Medium::outside, whole(outer), eye, detail);
    clock.end("instruments outside");
    gather_light(frame, inner, depth);
    clock.end("light of the pupil");
    soften(inner, depth, areas.pupil);
    clock.end("softened depth");
    find_instruments(inner);
    cast_shadows(inner);
    clock.end("shadows");
    const Regions where = regions_of(frame, outer, inner, stop_pixels);
    const bool still = kept_ && is_still(frame, inner, depth, detail, outer, stop_pixels);
    if (still && !kept_->is_written) {
        write_kept_light(where, frame, inner, depth, detail, outer);
        clock.end("light that is kept");
    }
    picture_.bind();
    if (still) {
        draw_kept(where, frame, inner, depth, detail, outer, clock);
    } else {
        draw_anew(where, frame, inner, depth, detail, outer, clock);
    }
    if (kept_) {
        kept_->is_written = still;
        kept_->time_s = frame.time_s;
    }
}

MicroscopeView::Regions MicroscopeView::regions_of(const Frame& frame, const View& outer, const View& inner,
                                                   double stop_pixels) {
    const EyeAnatomy& eye = *frame.eye;
    const std::vector<PixelRect> cornea = bands_around_circle(outer, eye.limbus_radius + 0.4, eye.limbus_z, 2);
    const std::vector<PixelRect> pupil = bands_around_circle(inner, opening_of(eye) + 0.05, eye.iris_z, 2);
    const std::vector<PixelRect> middle = bands_within_circle(inner, core_radius(frame), eye.iris_z);
    Regions where{without(without(bands_of(inner), cornea), pupil), without(cornea, pupil), without(pupil, middle),
                  middle, pupil};
    for (std::vector<PixelRect>* part : {&where.white, &where.iris, &where.edge, &where.middle, &where.pupil}) {
        *part = within_stop(std::move(*part), inner, stop_pixels);
    }
    return where;
}

/// Tiles of instruments and of their shadows.
void MicroscopeView::find_instruments(const View& inner) {
    tools_.clear();
    tools_.mark(inside_.covered().rects());
    tools_.mark(outside_.covered().rects());
    disturbed_.clear();
    for (const auto& [layer, shift] : {std::pair(&inside_, inner_shadow), std::pair(&outside_, outer_shadow)}) {
        const std::vector<PixelRect> stale = layer->stale().rects();
        disturbed_.mark(stale);
        for (const PixelRect& rect : stale) {
            disturbed_.mark(shadow_of(rect, shift, inner));
        }
    }
}

void MicroscopeView::draw_anew(const Regions& where, const Frame& frame, const View& inner, const DepthPass& depth,
                               const Texture& detail, const View& outer, PassClock& clock) {
    const std::array<const std::vector<PixelRect>*, 4> bands{&where.white, &where.iris, &where.edge, &where.middle};
    for (std::size_t part = 0; part < bands.size(); ++part) {
        compose(parts_[part].with(features_of(frame, part >= 2)), frame, inner, depth, detail, outer);
        draw_part(*bands[part]);
        clock.end(part_names[part]);
    }
    painted_.mark_all();
}

void MicroscopeView::write_kept_light(const Regions& where, const Frame& frame, const View& inner,
                                      const DepthPass& depth, const Texture& detail, const View& outer) {
    const unsigned front = features_of(frame, false);
    kept_->light.bind();
    compose(kept_->write_white.with(front), frame, inner, depth, detail, outer);
    draw_part(where.white);
    compose(kept_->write_iris.with(front), frame, inner, depth, detail, outer);
    draw_part(where.iris);
    draw_part(where.pupil);
}

/// Beyond the pupil only what instruments have changed, and a few bands of the iris at a time, over which the tear film
/// runs.
void MicroscopeView::draw_kept(const Regions& where, const Frame& frame, const View& inner, const DepthPass& depth,
                               const Texture& detail, const View& outer, PassClock& clock) {
    TileMask stale = disturbed_;
    const bool film_jumps = std::abs(frame.time_s - kept_->time_s) > film_jump_s;
    for (const PixelRect& band : where.iris) {
        if (film_jumps || !kept_->is_written || (band.y / band_rows + kept_->turn) % film_turns == 0) {
            stale.mark(band);
        }
    }
    ++kept_->turn;
    const std::array<std::vector<PixelRect>, 3> parts{stale.within(where.white), stale.within(where.iris), where.pupil};
    constexpr std::array names{"beyond the limbus", "iris", "pupil"};
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const Program& program = kept_->draw[part].with(features_of(frame, part == 2));
        compose(program, frame, inner, depth, detail, outer);
        program.set("kept", kept_->light.colours[0], 7);  // units of what these parts do not look up
        program.set("kept_added", kept_->light.colours[1], 8);
        draw_part(parts[part]);
        clock.end(names[part]);
    }
    painted_.clear();
    for (const std::vector<PixelRect>& part : parts) {
        painted_.mark(part);
    }
}

/// Whether the front of the eye is seen as in the picture before.
bool MicroscopeView::is_still(const Frame& frame, const View& inner, const DepthPass& depth, const Texture& detail,
                              const View& outer, double stop_pixels) {
    const auto* stop = reinterpret_cast<const unsigned char*>(&stop_pixels);
    kept_->now.assign(stop, stop + sizeof stop_pixels);
    kept_->now.push_back(static_cast<unsigned char>(features_of(frame, false)));
    for (ProgramVariants* variants : {&kept_->write_white, &kept_->write_iris}) {
        Program& program = variants->with(features_of(frame, false));
        program.log_to(&kept_->now);
        compose(program, frame, inner, depth, detail, outer);
        program.log_to(nullptr);
    }
    const bool same = kept_->now == kept_->parameters;
    kept_->parameters.swap(kept_->now);
    return same;
}

/// With the program in use.
void MicroscopeView::draw_part(const std::vector<PixelRect>& where) {
    if (!where.empty()) {
        rectangles_.send(triangles_of(where, picture_.width, picture_.height));
        rectangles_.draw();
    }
}

void MicroscopeView::draw_card(double reflectance, const EyeAnatomy& eye, const View& outer) {
    if (kept_) {
        kept_->parameters.clear();  // of a picture that is no more
    }
    painted_.mark_all();
    picture_.bind();
    steps_.card.use();
    set_view(steps_.card, outer);
    set_lamp(steps_.card, outer);
    steps_.card.set("limbus_z", eye.limbus_z);
    steps_.card.set("reflectance", reflectance);
    cover_target();
}

void MicroscopeView::gather_light(const Frame& frame, const View& inner, const DepthPass& depth) {
    const PupilOnScreen pupil = pupil_on_screen(*frame.eye, inner);
    const Program& program = steps_.light;
    light_.bind();
    program.use();
    set_view(program, inner);
    program.set("optical_depth", depth.optical_depth(), 0);
    program.set("stop", depth.stop(), 1);
    program.set("extinction_tint", depth.tint());
    program.set("pupil_centre", pupil.centre);
    program.set("pupil_reach", pupil.reach);
    cover_target();
}

void MicroscopeView::soften(const View& inner, const DepthPass& depth, const PixelRect& area) {
    const double pixels = softening_mm / pixel_mm(inner, depth.reference());
    const Program& program = steps_.soften;
    const Scissor scissor(halved(area));
    program.use();
    program.set("stop", depth.stop(), 1);
    across_.bind();
    program.set("source", depth.optical_depth(), 0);
    program.set("direction", Vec2(pixels / inner.width, 0.0));
    cover_target();
    soft_.bind();
    program.set("source", across_.colours[0], 0);
    program.set("direction", Vec2(0.0, pixels / inner.height));
    cover_target();
}

/// The lamp stands a little to the left and above: shadows fall to the right and below, further on what lies deeper.
void MicroscopeView::cast_shadows(const View& inner) {
    // They reach as far as what is disturbed: beyond that the picture before had none either.
    std::vector<PixelRect> where;
    for (const PixelRect& rect : disturbed_.rects()) {
        where.push_back({rect.x / shadow_scale, rect.y / shadow_scale, (rect.width + shadow_scale - 1) / shadow_scale,
                         (rect.height + shadow_scale - 1) / shadow_scale});
    }
    if (where.empty()) {
        return;
    }
    const double mm = 1.0 / pixel_mm(inner, Vec3::Zero());
    const Vec2 one_mm(mm / inner.width, mm / inner.height);
    const Program& program = steps_.shadows;
    shadows_.bind();
    program.use();
    program.set("inner_tools", inside_.picture(), 0);
    program.set("outer_tools", outside_.picture(), 1);
    program.set("inner_shift", Vec2(one_mm.cwiseProduct(inner_shadow)));
    program.set("outer_shift", Vec2(one_mm.cwiseProduct(outer_shadow)));
    rectangles_.send(triangles_of(where, shadows_.width, shadows_.height));
    rectangles_.draw();
}

void MicroscopeView::compose(const Program& program, const Frame& frame, const View& inner, const DepthPass& depth,
                             const Texture& detail, const View& outer) const {
    program.use();
    set_view(program, inner);
    program.set("optical_depth", depth.optical_depth(), 0);
    program.set("stop", depth.stop(), 1);
    program.set("front", front_.surface(), 2);
    program.set("relief", front_.relief(), 3);
    program.set("inner_tools", inside_.picture(), 4);
    program.set("outer_tools", outside_.picture(), 5);
    program.set("pupil_light", light_.colours[0], 6);
    program.set("iris_map", textures_->iris, 7);
    program.set("sclera_map", textures_->sclera, 8);
    program.set("sclera_relief", textures_->relief, 9);
    program.set("detail_map", detail, 10);
    program.set("soft_depth", soft_.colours[0], 11);
    program.set("shadows", shadows_.colours[0], 12);
    program.set("sheets", sheets_.picture(), 13);
    program.set("cracks", cracks_.picture(), 14);
    program.set("trypan_blue", frame.eye->trypan_blue);
    program.set("extinction_tint", depth.tint());
    program.set("lamp_share", lamp_share(outer));
    program.set("time_s", frame.time_s);
    set_lamp(program, outer);
    program.set("reference", depth.reference());
    program.set("pixel_mm", pixel_mm(inner, Vec3(0.0, 0.0, frame.eye->iris_z)));
    set_anatomy(program, *frame.eye);
    program.set("cortical_opacity", frame.eye->cortical_opacity);
    set_bag(program, frame);
    set_harm(program, frame);
}

}  // namespace rhexis
