// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/dot_image.hpp"

#include <cmath>
#include <numbers>

namespace rhexis::tracking {
namespace {

Vec2 direction_to(const Vec3& in_camera) { return in_camera.head<2>() / in_camera.z(); }

}  // namespace

Vec2 dot_off(const Lens& lens, const Pose& board, const Vec2& on_board, double radius_mm) {
    // The rim, centre + across cos t + down sin t, has the image of the circle (cos t, sin t, 1) under the matrix of
    // these three columns: the middle of a conic is where its dual has the line at infinity.
    const Vec3 centre = board.to_world({on_board.x(), on_board.y(), 0.0});
    const Vec3 across = radius_mm * (board.orientation * Vec3::UnitX());
    const Vec3 down = radius_mm * (board.orientation * Vec3::UnitY());
    const Vec3 middle = centre.z() * centre - across.z() * across - down.z() * down;
    return distorted(lens, direction_to(middle)) - distorted(lens, direction_to(centre));
}

double dot_radius(const Lens& lens, const Pose& board, const Vec2& on_board, double area) {
    const Vec3 centre = board.to_world({on_board.x(), on_board.y(), 0.0});
    const Eigen::Matrix<double, 2, 3> slope = projection_slope(lens, centre);
    Mat2 by_plane;
    by_plane << slope * (board.orientation * Vec3::UnitX()), slope * (board.orientation * Vec3::UnitY());
    return std::sqrt(area / (std::numbers::pi * std::abs(by_plane.determinant())));
}

}  // namespace rhexis::tracking
