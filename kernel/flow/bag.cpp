// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/bag.hpp"

#include "mesh/half_ellipsoids.hpp"

namespace rhexis {

SurfaceDistance bag_distance(const BagShape& shape, const Vec3& point) {
    const SurfacePoint closest = closest_on({shape.radius, shape.anterior, shape.posterior}, point);
    return {closest.distance, closest.normal};
}

}  // namespace rhexis
