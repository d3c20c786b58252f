// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the posterior capsule under an instrument. A clamped sheet of radius a, without tension, under a
// round end of radius R that has come a depth d too far; fits of the integrated sheet (docs/capsule.md), which for
// small R are a point's closed form [Komaragiri2005]. With y = d / a and s^2 = R d / a^2:
//   F = 1.183 E t a y^3 (1 + 1.47 s + 3.78 s^2) / (1 + 1.64 y^2)
// and the strain at its middle, with e = 0.1645 y^2 / s, which is how the strain beside a point falls [Schwerin1929]:
//   e (1 + 1.06 s) / (1 - 1.393 e)
// Sucked into a bore of radius b by p it is strained at its middle by 0.2415 q / (1 - 0.456 q), q^3 = (p b / (E t))^2.
// For Poisson's ratio 0.47, R / a of 0.05 to 0.4, y to 1, p b / (E t) to 1 and strains to 1.1: beyond, the denominators
// are kept above 0, where a linear sheet yields without end. It gives way at its ultimate strain; a hole grows while
// the pressure behind it yields more energy than its edge takes.
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
