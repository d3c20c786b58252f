// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the posterior capsule under an instrument. A dimple of radius a around a round end of radius R that
// has come a depth d too far [BegleyMackin2004]:
//   F = 9 pi / 16 E t d^3 / a^2 (R / a)^(3/4)
// strained most where the sheet meets the end; the strain of a sheet pulled to a point falls as r^(-2/3)
// [Schwerin1929], so that with the mean sqrt(1 + (d / a)^2) - 1 it is a third of (a / R)^(2/3) times that. Sucked into
// a bore of radius b by p it bulges by h = (3 (1 - nu) p b^4 / (8 E t))^(1/3) and strains by 2/3 (h / b)^2. It gives
// way at its ultimate strain; a hole grows while the pressure behind it yields more energy than its edge takes.
#pragma once

#include <span>

#include "flow/tool.hpp"
#include "flow/world.hpp"
#include "physics/fluid/mouth.hpp"

namespace rhexis {

double dimple_force(const CapsuleModel& capsule, double radius, double depth);   ///< [uN]
double dimple_strain(const CapsuleModel& capsule, double radius, double depth);  ///< depth of either sign
double bulge_strain(const CapsuleModel& capsule, double bore, double suction);

/// Energy that a hole's edge yields per area torn, with the pressure behind the capsule higher by `pressure` [uN/mm].
double hole_energy(const CapsuleModel& capsule, double wall_radius, double hole_radius, double pressure);

/// How far the end of a tool is through the posterior wall of a bag.
struct Dimple {
    double depth = 0.0;            ///< [mm]; 0: not at all
    Vec3 place = Vec3::Zero();     ///< in the bag's frame [mm]
    Vec3 normal = -Vec3::UnitZ();  ///< outward, in the bag's frame
};
Dimple dimple_of(const BagModel& bag, const CapsuleState& capsule, const Pose& bag_pose, const ToolModel& tool,
                 const Pose& tool_pose);

/// Force and torque about the bag's centre of all instruments on its posterior wall. Poses of tools as given.
Vec6 capsule_load(const WorldModel& model, const CapsuleState& capsule, const Pose& bag,
                  std::span<const ToolState> tools, std::span<const Pose> poses);

/// What a step of dt [s] did to the capsule: dimple, capture, strain, and whether it gave way. Reads tips, flows and
/// the bag of `state` as they are now.
void strain_capsule(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                    double dt, WorldState& state);

}  // namespace rhexis
