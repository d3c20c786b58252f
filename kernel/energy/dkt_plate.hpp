// SPDX-License-Identifier: GPL-3.0-or-later
// Bending of a thin triangle: the discrete Kirchhoff triangle [Batoz1980].
//
// The tilt grad w is a field of its own, quadratic over the triangle. It equals the nodal tilt (-theta_y, theta_x) at
// the corners; at the middle of a side of length l from i to j its component along the side is the slope of the cubic
// there,
//   1.5 (w_j - w_i) / l - 0.25 (slope_i + slope_j),
// and the one across it the mean of the ends. Curvature is linear, so the three middles of the sides integrate the
// energy exactly. It bends without shear, passes the patch test of constant curvature, and depends on neither numbering
// nor frame; the deflection between the corners is never needed.
#pragma once

#include "energy/plane_corners.hpp"

namespace rhexis {

/// Stiffness for (w, theta_x, theta_y) of each corner [uN/mm, uN, uN mm]; theta: rotation vector of the normal.
/// bending: moments per length over curvatures (w,xx; w,yy; 2 w,xy) [uN mm].
Mat9 dkt_stiffness(const PlaneCorners& corner, const Mat3& bending);

}  // namespace rhexis
