// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth closed surface: two half-ellipsoids of revolution about z that share the equator (z = 0).
#pragma once

#include "math/types.hpp"

namespace rhexis {

struct HalfEllipsoids {
    double radius = 4.6;     ///< equatorial [mm] > 0
    double anterior = 1.9;   ///< equatorial plane to anterior pole (+z) [mm] > 0
    double posterior = 2.7;  ///< equatorial plane to posterior pole (-z) [mm] > 0
};

/// sqrt((x^2 + y^2) / radius^2 + z^2 / c^2): 0 at the centre, 1 on the surface, grows linearly along rays.
double surface_level(const HalfEllipsoids& shape, const Vec3& point);

/// The point of the surface on the ray from the centre through `point` (which is not the centre).
Vec3 onto_surface(const HalfEllipsoids& shape, const Vec3& point);

/// Volume of the exact shape [mm^3].
double shape_volume(const HalfEllipsoids& shape);

/// Signed distance to the closest point of the surface (negative inside) and the outward unit normal there.
struct SurfacePoint {
    double distance = 0.0;  ///< [mm]
    Vec3 normal = Vec3::UnitZ();
};

/// Exact to rounding outside, and inside to a depth of c^2 / radius (the equator's sharper radius of curvature); deeper
/// points measure to the wall of their own half. Distance and normal are continuous across the equator down to there.
/// The closest point solves one monotone scalar equation by Newton's method.
SurfacePoint closest_on(const HalfEllipsoids& shape, const Vec3& point);

}  // namespace rhexis
