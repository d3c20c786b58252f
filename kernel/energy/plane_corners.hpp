// SPDX-License-Identifier: GPL-3.0-or-later
// The three corners of a flat triangle in its own plane, counter-clockwise, and what follows from them.
#pragma once

#include <array>

#include "math/types.hpp"

namespace rhexis {

using Mat9 = Eigen::Matrix<double, 9, 9>;
using PlaneCorners = std::array<Vec2, 3>;  ///< [mm]

inline double corner_area(const PlaneCorners& p) {
    const Vec2 a = p[1] - p[0];
    const Vec2 b = p[2] - p[0];
    return 0.5 * (a.x() * b.y() - a.y() * b.x());
}

/// Gradients of the linear shape functions [1/mm].
inline PlaneCorners corner_gradients(const PlaneCorners& p) {
    const double twice = 2.0 * corner_area(p);
    PlaneCorners gradient;
    for (std::size_t a = 0; a < 3; ++a) {
        const Vec2 opposite = p[(a + 2) % 3] - p[(a + 1) % 3];
        gradient[a] = Vec2(-opposite.y(), opposite.x()) / twice;
    }
    return gradient;
}

/// Isotropic plane stress: stress over strain (11, 22, engineering shear) [Pa].
inline Mat3 plane_stress(double young_modulus, double poisson_ratio) {
    const double c = young_modulus / (1.0 - poisson_ratio * poisson_ratio);
    Mat3 result;
    result << c, c * poisson_ratio, 0.0, c * poisson_ratio, c, 0.0, 0.0, 0.0, 0.5 * c * (1.0 - poisson_ratio);
    return result;
}

}  // namespace rhexis
