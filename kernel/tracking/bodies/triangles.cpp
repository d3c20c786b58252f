// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/bodies/triangles.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::tracking {
namespace {

MarkerTriangle triangle_of(const std::vector<Vec3>& markers, std::array<std::size_t, 3> of) {
    const auto across = [&](std::size_t marker) {
        const std::size_t one = of[0] == marker ? of[1] : of[0];
        const std::size_t other = of[2] == marker ? of[1] : of[2];
        return (markers[one] - markers[other]).norm();
    };
    MarkerTriangle triangle{of, {}};
    std::sort(triangle.markers.begin(), triangle.markers.end(),
              [&](std::size_t a, std::size_t b) { return across(a) < across(b); });
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.sides_mm[i] = across(triangle.markers[i]);
    }
    return triangle;
}

}  // namespace

std::vector<MarkerTriangle> triangles_of(const std::vector<Vec3>& markers) {
    std::vector<MarkerTriangle> all;
    for (std::size_t i = 0; i < markers.size(); ++i) {
        for (std::size_t j = i + 1; j < markers.size(); ++j) {
            for (std::size_t k = j + 1; k < markers.size(); ++k) {
                if (markers[i].allFinite() && markers[j].allFinite() && markers[k].allFinite()) {
                    all.push_back(triangle_of(markers, {i, j, k}));
                }
            }
        }
    }
    return all;
}

double apart_mm(const MarkerTriangle& one, const MarkerTriangle& other) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        greatest = std::max(greatest, std::abs(one.sides_mm[i] - other.sides_mm[i]));
    }
    return greatest;
}

}  // namespace rhexis::tracking
