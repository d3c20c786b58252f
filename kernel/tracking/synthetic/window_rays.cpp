// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/window_rays.hpp"

#include <algorithm>

namespace rhexis::tracking::synthetic {
namespace {

/// From values at -1, 0 and 1 to constant, linear and square term.
void to_parabola(Vec2& first, Vec2& second, Vec2& third) {
    const Vec2 linear = 0.5 * (third - first);
    const Vec2 square = 0.5 * (third + first) - second;
    first = second;
    second = linear;
    third = square;
}

}  // namespace

WindowRays::WindowRays(const TrueLens& lens, const Window& window)
    : middle_(0.5 * (window.left + window.right - 1), 0.5 * (window.top + window.bottom - 1)),
      half_(0.5 * window.width(), 0.5 * window.height()) {
    // down and across: by each, the values at -1, 0 and 1 become the terms of a parabola
    for (std::size_t i = 0; i < 3; ++i) {
        std::array<Vec2, 3> knots;
        for (std::size_t j = 0; j < 3; ++j) {
            const Vec2 place{static_cast<double>(j) - 1.0, static_cast<double>(i) - 1.0};
            knots[j] = undistorted(lens, middle_ + half_.cwiseProduct(place));
        }
        to_parabola(knots[0], knots[1], knots[2]);
        std::copy(knots.begin(), knots.end(), terms_.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        to_parabola(terms_[i], terms_[i + 3], terms_[i + 6]);
    }
}

}  // namespace rhexis::tracking::synthetic
