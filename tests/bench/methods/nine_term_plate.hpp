// SPDX-License-Identifier: GPL-3.0-or-later
// The plate of [Dequidt2013] eq. 5 to 8: the deflection is the polynomial
//   c1 + c2 x + c3 y + c4 x^2 + c5 xy + c6 y^2 + c7 x^3 + c8 x y^2 + c9 y^3,
// without x^2 y, fitted to deflection and slopes at the corners. It lost: constant curvature is not among what
// neighbours agree on, its answer depends on which side the x axis lies along, and it converges to plates that are too
// soft.
#pragma once

#include "energy/shell_triangle.hpp"

namespace rhexis::bench {

/// Stiffness for (w, theta_x, theta_y) of each corner in the corners' own axes, as dkt_stiffness().
Mat9 nine_term_stiffness(const PlaneCorners& corner, const Mat3& bending);

/// shell_triangle() with this plate; x along the first side.
ShellTriangle nine_term_triangle(const std::array<Vec3, 3>& rest, double thickness, double young_modulus,
                                 double poisson_ratio);

}  // namespace rhexis::bench
