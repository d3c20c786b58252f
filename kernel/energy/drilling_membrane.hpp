// SPDX-License-Identifier: GPL-3.0-or-later
// Stretching of a thin triangle whose corners also turn in its plane: the optimal triangle with drilling freedoms
// [Felippa2003], stiffness K = K_basic + K_higher:
//
//   K_basic  = L E L' / A, L: what a constant stress does to the freedoms
//   K_higher = 3/4 beta_0 T' [A sum_p Q_p' E_nat Q_p] T, T: corner rotations less that of the linear triangle;
//              Q_p: strains along the sides at the middle of side p; E_nat: E for strains along the sides
//
// With alpha = 3/2 and beta_1..9 = (1, 2, 1, 0, 1, -1, -1, -1, -2) a strip of them bends in its plane as a beam does,
// whatever their aspect. beta_0 = max((1 - 4 nu^2) / 2, 0.01).
#pragma once

#include "energy/plane_corners.hpp"

namespace rhexis {

/// Scale of the higher stiffness for a Poisson ratio (0 to 0.5).
double optimal_higher_share(double poisson_ratio);

/// Stiffness for (u, v, theta) of each corner [uN/mm, uN, uN mm]; theta: rotation about the normal. membrane: force per
/// length over strain (11, 22, engineering shear) [uN/mm]; higher: optimal_higher_share().
Mat9 drilling_stiffness(const PlaneCorners& corner, const Mat3& membrane, double higher);

}  // namespace rhexis
