// SPDX-License-Identifier: GPL-3.0-or-later
// Places of a triangle, as weights of its corners.
#pragma once

#include <array>

#include "math/types.hpp"

namespace rhexis {

inline Vec3 place_in(const std::array<Vec3, 3>& triangle, const std::array<double, 3>& weights) {
    return weights[0] * triangle[0] + weights[1] * triangle[1] + weights[2] * triangle[2];
}

/// The place of a triangle that is nearest to a point [Ericson2005].
std::array<double, 3> nearest_to_point(const std::array<Vec3, 3>& triangle, const Vec3& point);

/// Likewise to the segment from a to b; where it goes through the triangle, that place.
std::array<double, 3> nearest_to_segment(const std::array<Vec3, 3>& triangle, const Vec3& a, const Vec3& b);

}  // namespace rhexis
