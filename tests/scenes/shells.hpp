// SPDX-License-Identifier: GPL-3.0-or-later
// Shells for tests, benchmarks and demos.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "eye/implant.hpp"
#include "flow/shell.hpp"

namespace rhexis::scenes {

/// The disc of 742 triangles that other programs were timed with: clamped at one place of its rim, lifted at another.
struct LiftedDisc {
    ShellModel model;
    std::vector<int> lifted;
    Vec3 load = Vec3(0.0, 0.0, 300.0);  ///< in all [uN]
    Vec3 gravity = Vec3(0.0, 0.0, -9810.0);
    double step_s = 0.01;
    int warm_up_steps = 100;
    int measured_steps = 400;
};
Result<LiftedDisc> lifted_disc(const std::string& folder = ".");

/// A share of the load, evenly over the lifted nodes.
ShellLoad disc_load(const LiftedDisc& disc, double share);

/// The share at a time: it swells and fades every half second.
double moving_share(double time_s);

/// The implant held along a diameter of its optic, whose sides are pressed together above it.
struct FoldedOptic {
    Implant implant;  ///< with holds
    ShellLoad load;   ///< 1 uN towards the middle on either side, and half of it upwards
    int edge = 0;     ///< node at the optic's right
};
FoldedOptic folded_optic(int triangles);

/// At rest under this force on either side [uN], of the material's own modulus: as after a long time.
ShellState folded_state(const FoldedOptic& optic, double force);

/// How far the optic's right edge has turned up, -90 to 270 [deg].
double fold_degrees(const FoldedOptic& optic, const ShellState& state);

}  // namespace rhexis::scenes
