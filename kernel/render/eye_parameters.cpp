// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/eye_parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "math/roots.hpp"
#include "render/crack_layer.hpp"
#include "render/depth_pass.hpp"
#include "render/eye_balls.hpp"
#include "render/eye_textures.hpp"

namespace rhexis {

namespace {

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

constexpr double most_flap = 3.5;  ///< of Descemet's membrane, that is drawn: more lies rolled up [mm]

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

/// How far the cornea's back is folded beside each wound whose shaft bends it, in steps: 0 not at all, to 1.
std::array<double, lip_count> folded_cornea(const Frame& frame) {
    constexpr double least = 0.1;  // deflection at which a wound begins to gape [mm]
    constexpr double most = 0.5;   // beyond, folds grow no more. Proposal [mm]
    constexpr double steps = 16.0;
    std::array<double, lip_count> folded{};
    for (std::size_t i = 0; frame.globe && i < lip_count; ++i) {
        const double share = (frame.globe->lips[i].deflection.norm() - least) / (most - least);
        folded[i] = std::round(steps * std::clamp(share, 0.0, 1.0)) / steps;
    }
    return folded;
}

void set_striae(const Program& program, const Frame& frame) {
    const std::array<double, lip_count> folded = folded_cornea(frame);
    for (std::size_t i = 0; i < lip_count; ++i) {
        Eigen::Vector4d striae = Eigen::Vector4d::Zero();
        if (folded[i] > 0.0) {
            striae << frame.model->globe->lips[i], folded[i];
        }
        program.set(("striae[" + std::to_string(i) + "]").c_str(), striae);
    }
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

bool has_striae(const Frame& frame) {
    const std::array<double, lip_count> folded = folded_cornea(frame);
    return std::any_of(folded.begin(), folded.end(), [](double share) { return share > 0.0; });
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
constexpr std::array features{Feature{"SHEETS", has_sheets, false},  Feature{"CRACKS", has_cracks, false},
                              Feature{"CRUMBS", has_crumbs, false},  Feature{"CELLS", has_cells, false},
                              Feature{"HARM", has_harm, false},      Feature{"OPTIC", has_optic, false},
                              Feature{"ZONULES", has_zonules, true}, Feature{"WOUNDS", has_wounds, true},
                              Feature{"CAUGHT", is_caught, true},    Feature{"STRIAE", has_striae, true}};

}  // namespace

double opening_of(const EyeAnatomy& eye) { return eye.has_iris ? eye.pupil_radius : eye.limbus_radius; }

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

double flap_of(const Frame& frame) {
    double flap = 0.0;
    if (frame.wounds) {
        for (const Wound& wound : frame.wounds->wounds) {
            flap = std::max(flap, std::min(wound.peel, most_flap));
        }
    }
    return flap;
}

void set_anatomy(const Program& program, const EyeAnatomy& eye) {
    program.set("cornea", cornea_ball(eye));
    program.set("cornea_back", cornea_back_ball(eye));
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

/// What a posterior capsule that is held or open shows, and an iris that is caught.
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
    set_striae(program, frame);
    program.set("crumbs_are_beads", frame.model->beads.has_value() ? 1 : 0);
}

void set_crumbs(const Program& program, const Frame& frame) {
    const std::size_t crumbs = std::min(frame.debris.size(), most_crumbs);
    program.set("crumb_count", static_cast<int>(crumbs));
    for (std::size_t i = 0; i < crumbs; ++i) {
        const Debris& crumb = frame.debris[i];
        Eigen::Vector4d ball;
        ball << crumb.position, radius_of(crumb);
        program.set(("crumbs[" + std::to_string(i) + "]").c_str(), ball);
    }
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

unsigned features_of(const Frame& frame, bool in_pupil) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < features.size(); ++i) {
        if ((in_pupil || features[i].beyond_pupil) && features[i].shows(frame)) {
            bits |= 1U << i;
        }
    }
    return bits;
}

unsigned crumb_feature() {
    const auto* crumbs =
        std::find_if(features.begin(), features.end(), [](const Feature& one) { return one.shows == has_crumbs; });
    return 1U << (crumbs - features.begin());
}

std::vector<const char*> feature_names() {
    std::vector<const char*> names;
    for (const Feature& feature : features) {
        names.push_back(feature.name);
    }
    return names;
}

}  // namespace rhexis
