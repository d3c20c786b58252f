// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of sight of a picture, outside the eye and inside it.
//
// A single refracting surface of power P = (n - 1) / R in front of a medium of index n shows a point at depth d behind
// its apex and distance x from its axis at d' = d / (n - P d), x' = n x / (n - P d) (paraxial optics). That map is
// projective: it takes lines to lines. Hence what lies behind the cornea is drawn by one more matrix, and the rays
// inside the eye are again straight lines through one point (a "camera" that may lie behind the eye: the rays
// converge).
#pragma once

#include "flow/frame.hpp"

namespace rhexis {

using Mat4 = Eigen::Matrix4d;
using Vec4 = Eigen::Vector4d;

/// All lines of sight of one picture in one medium. Positions along a ray are measured by `depth`: the distance along
/// `axis` from the plane through `plane_point`, so that small numbers describe the scene however far the camera is.
struct View {
    int width = 1;
    int height = 1;
    Mat4 clip_from_world = Mat4::Identity();  ///< OpenGL clip coordinates
    Vec3 eye = Vec3::Zero();                  ///< of the camera, outside [mm]
    Vec3 forward = Vec3::Zero();              ///< outside: direction of a pixel is forward + x right + y up,
    Vec3 right = Vec3::Zero();                ///< with x and y in [-1, 1]
    Vec3 up = Vec3::Zero();
    Vec3 axis = Vec3::Zero();  ///< unit, away from the camera
    Vec3 plane_point = Vec3::Zero();
    Vec4 centre = Vec4::Zero();  ///< homogeneous: where all lines of this medium meet

    [[nodiscard]] double depth(const Vec3& point) const { return axis.dot(point - plane_point); }
};

/// The camera in air. width, height in pixels.
View view_in_air(const Camera& camera, int width, int height);

/// The same camera seen from behind the cornea of this eye.
View view_through_cornea(const Camera& camera, int width, int height, const EyeAnatomy& eye);

/// A line of sight. Between two points of it, distance = difference in depth * stretch.
struct Ray {
    Vec3 at_plane = Vec3::Zero();    ///< where depth is 0 [mm]
    Vec3 direction = Vec3::UnitZ();  ///< unit, away from the camera
    double stretch = 1.0;
};

/// Ray through the centre of a pixel; x from the left, y from the top.
Ray pixel_ray(const View& view, int x, int y);

/// Height of a pixel in air, at the distance of a point [mm].
double pixel_mm(const View& view, const Vec3& point);

/// Where a point of this medium shows, in pixels from the top left corner (centres at half-integers).
Vec2 pixel_of(const View& view, const Vec3& point);

}  // namespace rhexis
