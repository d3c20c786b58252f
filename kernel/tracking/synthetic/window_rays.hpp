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

    /// One line of the image, whose points only differ in x.
    struct Line {
        Vec2 constant;
        Vec2 linear;
        Vec2 square;
        double middle;
        double per_half;

        /// (X/Z, Y/Z, 1) of a point; pixel centres have whole coordinates.
        [[nodiscard]] Vec3 at(double x) const {
            const double u = (x - middle) * per_half;
            const Vec2 direction = constant + u * (linear + u * square);
            return {direction.x(), direction.y(), 1.0};
        }
    };
    [[nodiscard]] Line line(double y) const {
        const double v = (y - middle_.y()) / half_.y();
        const auto along = [&](std::size_t i) -> Vec2 { return terms_[i] + v * (terms_[i + 3] + v * terms_[i + 6]); };
        return {along(0), along(1), along(2), middle_.x(), 1.0 / half_.x()};
    }
    [[nodiscard]] Vec3 at(double x, double y) const { return line(y).at(x); }

private:
    Vec2 middle_;
    Vec2 half_;
    std::array<Vec2, 9> terms_{};  ///< of u^i v^j at i + 3 j, u and v from -1 to 1 over the window
};

}  // namespace rhexis::tracking::synthetic
