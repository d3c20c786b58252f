// SPDX-License-Identifier: GPL-3.0-or-later
// Where a lens shows a direction and a sphere, for plain numbers and for those that carry derivatives with them.
#pragma once

#include <array>

#include "tracking/camera.hpp"

namespace rhexis::tracking {

/// fx fy cx cy k1 k2 p1 p2 k3, in this order.
using LensNumbers = std::array<double, 9>;

inline LensNumbers numbers_of(const Lens& lens) {
    return {lens.fx, lens.fy, lens.cx, lens.cy, lens.k1, lens.k2, lens.p1, lens.p2, lens.k3};
}

inline Lens lens_of(const LensNumbers& numbers) {
    return {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5], numbers[6], numbers[7], numbers[8]};
}

/// A direction after the distortion [Brown1971] of a lens of these numbers, before its focal length; see Lens.
template <typename T>
Eigen::Matrix<T, 2, 1> bent_direction(const T* lens, const Eigen::Matrix<T, 2, 1>& direction) {
    const T& x = direction.x();
    const T& y = direction.y();
    const T r2 = x * x + y * y;
    const T radial = T(1.0) + r2 * (lens[4] + r2 * (lens[5] + r2 * lens[8]));
    return {x * radial + T(2.0) * lens[6] * x * y + lens[7] * (r2 + T(2.0) * x * x),
            y * radial + lens[6] * (r2 + T(2.0) * y * y) + T(2.0) * lens[7] * x * y};
}

/// The image of a direction [pixels].
template <typename T>
Eigen::Matrix<T, 2, 1> lens_image(const T* lens, const Eigen::Matrix<T, 2, 1>& direction) {
    const Eigen::Matrix<T, 2, 1> bent = bent_direction(lens, direction);
    return {lens[0] * bent.x() + lens[2], lens[1] * bent.y() + lens[3]};
}

/// The direction of the middle of a sphere's image, which is an ellipse: not that of the sphere's centre. The cone that
/// touches the sphere meets the plane at 1 in an ellipse about (X Z, Y Z) / (Z^2 - R^2). `in_camera`: the sphere's
/// centre [mm], farther before the camera than its radius. A radius of 0: the direction of a point.
template <typename T>
Eigen::Matrix<T, 2, 1> sphere_direction(const Eigen::Matrix<T, 3, 1>& in_camera, double radius_mm) {
    const T& z = in_camera.z();
    const T scale = z / (z * z - T(radius_mm * radius_mm));
    return {in_camera.x() * scale, in_camera.y() * scale};
}

}  // namespace rhexis::tracking
