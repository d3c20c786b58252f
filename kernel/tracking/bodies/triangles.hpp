// SPDX-License-Identifier: GPL-3.0-or-later
// Three markers of a body, which are enough to know it by: what may be mistaken for what.
#pragma once

#include <array>
#include <vector>

#include "tracking/marker_body.hpp"

namespace rhexis::tracking {

struct MarkerTriangle {
    std::array<std::size_t, 3> markers{};  ///< each across the side of its place
    std::array<double, 3> sides_mm{};      ///< from the shortest to the longest
};

/// All threes of a body's markers that are at finite places.
std::vector<MarkerTriangle> triangles_of(const std::vector<Vec3>& markers);

/// The greatest difference of two sides where each is set against one of the other so that it is least: in order of
/// length. [mm]
double apart_mm(const MarkerTriangle& one, const MarkerTriangle& other);

}  // namespace rhexis::tracking
