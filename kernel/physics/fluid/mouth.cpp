// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/fluid/mouth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh/components.hpp"
#include "physics/contact/tissue_near.hpp"
#include "physics/fluid/debris_motion.hpp"

namespace rhexis {

namespace {

constexpr std::array<double, 4> look_depths{0.05, seal, 0.3, kept_seal};  ///< in front of the mouth [mm]
constexpr double shut = 0.85;           ///< share of the mouth that must be covered to shut it. Proposal
constexpr double kept_shut = 0.65;      ///< once lens has shut it: suction has drawn it in. Proposal
constexpr double most_following = 0.5;  ///< share of the lens that a piece may be which follows the flow. Proposal

/// Out along the mouth's normal to the surface of the rounded end.
Vec3 on_end(const RoundedCone& end, const Vec3& facing, const Vec3& point) {
    const Vec3 from_centre = point - end.a;
    const double along = facing.dot(from_centre);
    const double room = end.radius_a * end.radius_a - from_centre.squaredNorm() + along * along;
    return point + (std::sqrt(std::max(0.0, room)) - along) * facing;
}

bool covered_by_lens(const std::vector<FineTissue>& tissue, const SolidState& lens, std::span<const Vec3> spots) {
    return std::any_of(tissue.begin(), tissue.end(), [&](const FineTissue& fine) {
        return lens.fraction[fine.tet] > 0.3 &&
               std::any_of(spots.begin(), spots.end(), [&](const Vec3& spot) { return holds(fine.corners, spot); });
    });
}

/// Whether what is right before the mouth is a piece that the flow draws after the tip as ultrasound eats its way in.
/// The lens as a whole does not come: what is cleared before the mouth lets fluid in.
bool follows(const WorldModel& model, const WorldState& state, int tool, const Mouth& mouth, const Pose& pose) {
    const SolidState& lens = state.solids[0];
    if (lens.splits.empty()) {
        return false;
    }
    const std::vector<BeforeMouth> near = before_mouth(model, state, tool, mouth, pose);
    const auto left = std::find_if(near.begin(), near.end(),
                                   [&](const BeforeMouth& one) { return lens.fraction[one.fine] > still_there; });
    if (left == near.end()) {
        return false;
    }
    const TetMesh& mesh = model.solids[0].coarse;
    const std::vector<int> pieces = pieces_by_nodes(mesh.tets, mesh.nodes.size(), lens.present);
    const auto size = std::count(pieces.begin(), pieces.end(), pieces[static_cast<std::size_t>(left->fine / 8)]);
    return static_cast<double>(size) < most_following * static_cast<double>(pieces.size());
}

bool covered_by_capsule(const WorldModel& model, const WorldState& state, const Vec3& spot) {
    if (!state.capsule) {
        return false;
    }
    const Vec3 local = state.bags[0].pose.to_body(spot);
    return local.z() < 0.0 && !within_hole(*state.capsule, local) &&
           bag_distance(model.bags[0].shape, local).distance > 0.0;
}

bool covered_by_iris(const WorldModel& model, const WorldState& state, const Vec3& spot) {
    if (!state.iris) {
        return false;
    }
    const double rho = spot.head<2>().norm();
    return rho > state.iris->pupil_radius && rho < model.iris->root_radius &&
           std::abs(spot.z() - state.iris->z) < 0.5 * model.iris->thickness;
}

}  // namespace

MouthProbe mouth_probe(const ToolModel& tool) {
    MouthProbe probe;
    const bool aspirates =
        tool.kind == ToolKind::phaco || tool.kind == ToolKind::cutter || tool.kind == ToolKind::aspirator;
    if (!aspirates || tool.parts.empty() || !(tool.bore_radius > 0.0)) {
        return probe;
    }
    probe.mouth = tip_mouth(tool);
    probe.area = std::numbers::pi * tool.bore_radius * tool.bore_radius;
    const Vec3 right = Vec3::UnitX();
    const Vec3 up = probe.mouth.facing.cross(right);
    // 1 + 6 + 12 points of equal area, in rings; directions by roots, the same bits on every machine
    const double half_root3 = 0.5 * std::sqrt(3.0);
    const std::array<Vec2, 12> directions{Vec2(1, 0),
                                          Vec2(0.5, half_root3),
                                          Vec2(-0.5, half_root3),
                                          Vec2(-1, 0),
                                          Vec2(-0.5, -half_root3),
                                          Vec2(0.5, -half_root3),
                                          Vec2(half_root3, 0.5),
                                          Vec2(0, 1),
                                          Vec2(-half_root3, 0.5),
                                          Vec2(-half_root3, -0.5),
                                          Vec2(0, -1),
                                          Vec2(half_root3, -0.5)};
    const auto add = [&](double radius, const Vec2& direction) {
        const Vec3 on_disc =
            probe.mouth.centre + radius * tool.bore_radius * (direction.x() * right + direction.y() * up);
        probe.points.push_back(on_end(tool.parts.front(), probe.mouth.facing, on_disc));
    };
    add(0.0, Vec2::Zero());
    for (int i = 0; i < 6; ++i) {
        add(0.4, directions[i]);
    }
    for (const Vec2& direction : directions) {
        add(0.8, direction);
    }
    return probe;
}

std::vector<BeforeMouth> before_mouth(const WorldModel& model, const WorldState& state, int tool, const Mouth& mouth,
                                      const Pose& pose) {
    std::vector<BeforeMouth> found;
    const ToolModel& tip = model.tools[tool];
    const double wide = tip.bore_radius + seal;
    for (const FineTissue& fine : tissue_near(model.solids[0], state.solids[0], tip.parts.front(), pose, kept_seal)) {
        const Vec3 middle = 0.25 * (fine.corners[0] + fine.corners[1] + fine.corners[2] + fine.corners[3]);
        const Vec3 from_mouth = pose.to_body(middle) - mouth.centre;
        const double along = mouth.facing.dot(from_mouth);
        if (along > -seal && from_mouth.squaredNorm() - along * along < wide * wide) {
            found.push_back({fine.tet, from_mouth.norm()});
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const BeforeMouth& a, const BeforeMouth& b) { return a.distance < b.distance; });
    return found;
}

double hold_of_lens(const TipState& tip) {
    return tip.lens > 0.0 ? tip.hold * tip.lens / (tip.lens + tip.capsule + tip.iris + tip.debris) : 0.0;
}

double open_share(double covered, bool was_shut) {
    return std::clamp(1.0 - covered / (was_shut ? kept_shut : shut), 0.0, 1.0);
}

TipState look_at_mouth(const WorldModel& model, const WorldState& state, int tool, const ToolState& tool_state,
                       const MouthProbe& probe) {
    TipState tip;
    if (probe.points.empty() || !tool_state.present) {
        return tip;
    }
    const Pose& pose = tool_state.pose;
    const bool was_shut = state.tips[tool].lens > 0.5 && state.tips[tool].suction > least_suction;
    // suction draws soft tissue across a gap, and ultrasound throws it back
    const bool drawn_in = was_shut && (!(tool_state.power > 0.0) || follows(model, state, tool, probe.mouth, pose));
    const std::size_t far = drawn_in ? look_depths.size() : (tool_state.power > 0.0 ? 2 : 3);
    std::vector<FineTissue> tissue;
    if (!state.solids.empty() && !state.solids[0].fraction.empty()) {
        tissue =
            tissue_near(model.solids[0], state.solids[0], model.tools[tool].parts.front(), pose, look_depths[far - 1]);
    }
    const double each = 1.0 / static_cast<double>(probe.points.size());
    const Vec3 facing = pose.orientation * probe.mouth.facing;
    for (const Vec3& point : probe.points) {
        const Vec3 place = pose.to_world(point);
        std::array<Vec3, look_depths.size()> spots;
        std::transform(look_depths.begin(), look_depths.end(), spots.begin(),
                       [&](double look) { return Vec3(place + look * facing); });
        if (covered_by_iris(model, state, spots[0])) {
            tip.iris += each;
        } else if (covered_by_capsule(model, state, spots[1])) {
            tip.capsule += each;
        } else if (!tissue.empty() && covered_by_lens(tissue, state.solids[0], std::span(spots).first(far))) {
            tip.lens += each;
        }
    }
    const Vec3 centre = pose.to_world(probe.mouth.centre);
    if (std::any_of(state.debris.begin(), state.debris.end(),
                    [&](const Debris& crumb) { return shuts(crumb, model.tools[tool], centre); })) {
        tip.debris = 1.0 - tip.lens - tip.capsule - tip.iris;
    }
    if (state.iris && state.iris->tool == tool) {
        tip.iris = 1.0 - tip.lens - tip.capsule - tip.debris;  // it is drawn over what else was open
    }
    if (state.capsule && state.capsule->captured && state.capsule->tool == tool) {
        tip.capsule = 1.0 - tip.lens - tip.iris - tip.debris;
    }
    tip.open = open_share(tip.lens + tip.capsule + tip.iris + tip.debris, was_shut);
    return tip;
}

}  // namespace rhexis
