// SPDX-License-Identifier: GPL-3.0-or-later
// What trials measure of a solid, whichever way it is advanced.
#pragma once

#include <vector>

#include "energy/corotational_tet.hpp"
#include "flow/solid.hpp"

namespace rhexis::scenes {

TetPoints corners(const std::vector<Vec3>& x, const std::array<int, 4>& tet);

/// Share of the tetrahedra whose volume is not positive.
double inverted_share(const SolidModel& model, const SolidState& state);

/// In double, with the stiffness that both ways give to what is left of each tetrahedron [nJ].
double elastic_energy(const SolidModel& model, const SolidState& state);

/// Mean deflection of the end face of the bar of the bending table (x = 4 mm) towards -z [mm].
double tip_sag(const SolidModel& model, const std::vector<Vec3>& position);

/// Momentum, angular momentum about the origin, and their scales.
struct Motion {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
    double linear_scale = 0.0;   ///< sum of m |v|
    double angular_scale = 0.0;  ///< sum of m |r| |v|
    double kinetic = 0.0;        ///< [nJ]
    double heat = 0.0;           ///< of it, relative to the mean motion [nJ]
};
/// mass: per node [g].
Motion motion_of(const SolidState& state, const std::vector<double>& mass);

/// How far from rest a body starts: every node at a random place of the body's box, or all on one plane, or mirrored.
enum class BadStart { random, flat, mirrored };
void place_badly(SolidState& state, BadStart start);

}  // namespace rhexis::scenes
