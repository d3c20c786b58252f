// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/capsule_wall.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/roots.hpp"

namespace rhexis {

namespace {

constexpr double wall_catching = 0.5;  ///< share of the mouth that the capsule must cover to be caught. Proposal
constexpr double first_hole = 0.3;     ///< radius of a fresh hole [mm]. Proposal

/// Radius of what meets the sheet: the edge of an open tip is sharper than its round end.
double contact_radius(const ToolModel& tool) {
    return tool.edge_radius > 0.0 ? tool.edge_radius : tool.parts.front().radius_a;
}

/// Strain of a sheet that yields the more the further it is strained: `linear` is what it would be at small loads.
double yielding(double linear, double softening) {
    constexpr double least = 0.05;  // of what a sheet keeps: far beyond what a capsule bears
    return linear / std::max(least, 1.0 - softening * linear);
}

double hold_of(const TipState& tip, const MouthProbe& probe) { return tip.suction * probe.area; }

/// Distance of a mouth from the wall, into the bag; negative: beyond it [mm].
double drawn_in(const WorldModel& model, const WorldState& state, const ToolState& tool, const MouthProbe& probe) {
    const Vec3 local = state.bags[0].pose.to_body(tool.pose.to_world(probe.mouth.centre));
    return -bag_distance(model.bags[0].shape, local).distance;
}

void catch_capsule(std::span<const ToolState> tools, std::span<const MouthProbe> probes, WorldState& state) {
    CapsuleState& capsule = *state.capsule;
    for (std::size_t i = 0; i < tools.size() && !capsule.captured; ++i) {
        if (state.tips[i].capsule >= wall_catching && state.tips[i].suction >= least_suction) {
            capsule.captured = true;
            capsule.tool = static_cast<int>(i);
            capsule.place = state.bags[0].pose.to_body(tools[i].pose.to_world(probes[i].mouth.centre));
        }
    }
}

/// The deepest dimple of any tool.
void find_dimple(const WorldModel& model, std::span<const ToolState> tools, WorldState& state) {
    CapsuleState& capsule = *state.capsule;
    capsule.tool = -1;
    capsule.depth = 0.0;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (!tools[i].present) {
            continue;
        }
        const Dimple dimple = dimple_of(model.bags[0], capsule, state.bags[0].pose, model.tools[i], tools[i].pose);
        if (dimple.depth > capsule.depth) {
            capsule.tool = static_cast<int>(i);
            capsule.depth = dimple.depth;
            capsule.place = dimple.place;
        }
    }
}

void strain_captured(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                     WorldState& state) {
    CapsuleState& capsule = *state.capsule;
    const int tool = capsule.tool;
    const MouthProbe& probe = probes[tool];
    const double bore = model.tools[tool].bore_radius;
    const double pull = drawn_in(model, state, tools[tool], probe);
    if (!tools[tool].present || state.tips[tool].suction < least_suction ||
        dimple_force(*model.capsule, bore, std::max(0.0, pull)) > hold_of(state.tips[tool], probe)) {
        capsule.captured = false;
        capsule.tool = -1;
        capsule.depth = 0.0;
        return;
    }
    capsule.depth = -pull;
    capsule.strain =
        bulge_strain(*model.capsule, bore, state.tips[tool].suction) + dimple_strain(*model.capsule, bore, pull);
}

void give_way(const WorldModel& model, WorldState& state) {
    CapsuleState& capsule = *state.capsule;
    const double bore = model.tools[capsule.tool].bore_radius;
    const double fresh = capsule.captured ? std::max(first_hole, bore) : first_hole;
    if (capsule.hole_radius == 0.0) {
        capsule.hole_place = capsule.place;
    }
    capsule.hole_radius += fresh;
    capsule.captured = false;
    capsule.tool = -1;
    capsule.depth = 0.0;
}

void tear_on(const WorldModel& model, double dt, WorldState& state) {
    CapsuleState& capsule = *state.capsule;
    if (capsule.hole_radius == 0.0 || !state.chamber) {
        return;
    }
    // The vitreous keeps the pressure of rest for a while when the chamber loses it; where it is simulated, its own.
    const double behind = state.vitreous
                              ? state.vitreous->drive
                              : std::max(0.0, model.chamber->rest_pressure - state.flows.lowest_eye_pressure);
    const BagShape& shape = model.bags[0].shape;
    const double wall_radius = shape.radius * shape.radius / shape.posterior;
    const double excess =
        hole_energy(*model.capsule, wall_radius, capsule.hole_radius, behind) / model.capsule->tear_energy - 1.0;
    if (excess > 0.0) {
        capsule.hole_radius =
            std::min(capsule.hole_radius + model.capsule->tear_speed * std::min(excess, 3.0) * dt, 0.8 * shape.radius);
    }
}

}  // namespace

double dimple_force(const CapsuleModel& capsule, double radius, double depth) {
    const double share = depth / capsule.dimple_radius;
    const double round = radius / capsule.dimple_radius * share;
    return 1.183 * capsule.membrane_stiffness * capsule.dimple_radius * share * share * share *
           (1.0 + 1.47 * std::sqrt(round) + 3.78 * round) / (1.0 + 1.64 * share * share);
}

double dimple_strain(const CapsuleModel& capsule, double radius, double depth) {
    const double share = std::abs(depth) / capsule.dimple_radius;
    const double round = std::sqrt(radius / capsule.dimple_radius * share);
    const double beside_a_point = share > 0.0 ? 0.1645 * share * share / round : 0.0;
    return yielding(beside_a_point, 1.393) * (1.0 + 1.06 * round);
}

double bulge_strain(const CapsuleModel& capsule, double bore, double suction) {
    const double root = cube_root(suction * bore / capsule.membrane_stiffness);
    return 0.2415 * yielding(root * root, 0.456);
}

double hole_energy(const CapsuleModel& capsule, double wall_radius, double hole_radius, double pressure) {
    const double tension = 0.5 * pressure * wall_radius;
    return tension * tension * std::numbers::pi * hole_radius / (capsule.membrane_stiffness * capsule.thickness);
}

Dimple dimple_of(const BagModel& bag, const CapsuleState& capsule, const Pose& bag_pose, const ToolModel& tool,
                 const Pose& tool_pose) {
    const RoundedCone& end = tool.parts.front();
    const Vec3 centre = bag_pose.to_body(tool_pose.to_world(end.a));
    if (!(centre.z() < 0.0) || within_hole(capsule, centre)) {
        return {};
    }
    const SurfaceDistance found = bag_distance(bag.shape, centre);
    return {std::max(0.0, found.distance + end.radius_a), centre - found.distance * found.normal, found.normal};
}

namespace {

/// Force on the bag at a place of its wall, both in the bag's frame, as force and torque in the world's.
Vec6 wrench_of(const Pose& bag, const Vec3& place, const Vec3& force) {
    Vec6 wrench;
    wrench << bag.orientation * force, bag.orientation * place.cross(force);
    return wrench;
}

/// Of a mouth that holds the wall and draws it in.
Vec6 pull_of(const WorldModel& model, const Pose& bag, const ToolModel& tool, const Pose& pose) {
    const Vec3 local = bag.to_body(pose.to_world(tip_mouth(tool).centre));
    const SurfaceDistance found = bag_distance(model.bags[0].shape, local);
    const double pull = std::max(0.0, -found.distance);
    return wrench_of(bag, local - found.distance * found.normal,
                     -dimple_force(*model.capsule, tool.bore_radius, pull) * found.normal);
}

}  // namespace

Vec6 capsule_load(const WorldModel& model, const CapsuleState& capsule, const Pose& bag,
                  std::span<const ToolState> tools, std::span<const Pose> poses) {
    Vec6 load = Vec6::Zero();
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const ToolModel& tool = model.tools[i];
        if (!tools[i].present) {
            continue;
        }
        if (capsule.captured && capsule.tool == static_cast<int>(i)) {
            load += pull_of(model, bag, tool, poses[i]);
            continue;
        }
        const Dimple dimple = dimple_of(model.bags[0], capsule, bag, tool, poses[i]);
        if (dimple.depth > 0.0) {
            const double force = dimple_force(*model.capsule, tool.parts.front().radius_a, dimple.depth);
            load += wrench_of(bag, dimple.place, force * dimple.normal);
        }
    }
    return load;
}

void strain_capsule(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                    double dt, WorldState& state) {
    CapsuleState& capsule = *state.capsule;
    capsule.strain = 0.0;
    if (!capsule.captured) {
        catch_capsule(tools, probes, state);
    }
    if (capsule.captured) {
        strain_captured(model, tools, probes, state);
    }
    if (!capsule.captured) {
        find_dimple(model, tools, state);
        if (capsule.tool >= 0) {
            capsule.strain = dimple_strain(*model.capsule, contact_radius(model.tools[capsule.tool]), capsule.depth);
        }
    }
    capsule.force = state.bags[0].load.head<3>();
    capsule.peak_strain = std::max(capsule.peak_strain, capsule.strain);
    if (capsule.tool >= 0) {
        const double weakened = 1.0 - model.capsule->ultrasound_damage * tools[capsule.tool].power;
        if (capsule.strain > model.capsule->ultimate_strain * weakened) {
            give_way(model, state);
        }
    }
    tear_on(model, dt, state);
}

}  // namespace rhexis
