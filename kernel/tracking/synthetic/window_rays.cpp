// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/window_rays.hpp"

namespace rhexis::tracking::synthetic {

WindowRays::WindowRays(const TrueLens& lens, const Window& window)
    : middle_(0.5 * (window.left + window.right - 1), 0.5 * (window.top + window.bottom - 1)),
      half_(0.5 * window.width(), 0.5 * window.height()) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const Vec2 pixel = middle_ + half_.cwiseProduct(Vec2(j - 1, i - 1));
            knots_[static_cast<std::size_t>(3 * i + j)] = undistorted(lens, pixel);
        }
    }
}

}  // namespace rhexis::tracking::synthetic
