// SPDX-License-Identifier: GPL-3.0-or-later
// Rays of all points of a small part of an image: the lens is inverted at nine points, and between them by squares.
#pragma once

#include <array>

#include "tracking/synthetic/sensor.hpp"
#include "tracking/synthetic/true_camera.hpp"

namespace rhexis::tracking::synthetic {

/// Of a window of up to 64 pixels a side, to a thousandth of a pixel for lenses of up to 60 degrees.
class WindowRays {
public:
    WindowRays(const TrueLens& lens, const Window& window);

    /// (X/Z, Y/Z, 1) of a pixel's point; pixel centres have whole coordinates.
    [[nodiscard]] Vec3 at(double x, double y) const {
        const std::array<double, 3> across = weights((x - middle_.x()) / half_.x());
        const std::array<double, 3> down = weights((y - middle_.y()) / half_.y());
        Vec3 ray{0.0, 0.0, 1.0};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                ray.head<2>() += down[i] * across[j] * knots_[3 * i + j];
            }
        }
        return ray;
    }

private:
    static std::array<double, 3> weights(double u) { return {0.5 * u * (u - 1.0), 1.0 - u * u, 0.5 * u * (u + 1.0)}; }

    Vec2 middle_;
    Vec2 half_;
    std::array<Vec2, 9> knots_{};
};

}  // namespace rhexis::tracking::synthetic
