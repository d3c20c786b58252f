// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/view.hpp"

#include <algorithm>
#include <cmath>

#include "flow/corneal_image.hpp"

namespace rhexis {

namespace {

constexpr double reach = 80.0;  ///< the scene lies within this distance of the target along the axis [mm]

Mat4 projection(double tan_x, double tan_y, double near, double far) {
    Mat4 matrix = Mat4::Zero();
    matrix(0, 0) = 1.0 / tan_x;
    matrix(1, 1) = 1.0 / tan_y;
    matrix(2, 2) = (far + near) / (far - near);
    matrix(2, 3) = -2.0 * far * near / (far - near);
    matrix(3, 2) = 1.0;
    return matrix;
}

/// World to right, up, away from the camera.
Mat4 placement(const Vec3& eye, const Vec3& right, const Vec3& up, const Vec3& forward) {
    Mat4 matrix = Mat4::Identity();
    matrix.block<1, 3>(0, 0) = right.transpose();
    matrix.block<1, 3>(1, 0) = up.transpose();
    matrix.block<1, 3>(2, 0) = forward.transpose();
    matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * eye;
    return matrix;
}

Vec3 right_of(const Vec3& forward, const Vec3& up) {
    const Vec3 right = forward.cross(up);
    return right.norm() > 1e-9 ? Vec3(right.normalized()) : forward.unitOrthogonal();
}

/// Real to virtual position of what lies behind the cornea, as a homogeneous matrix.
Mat4 corneal_image(double apex_z, double power) {
    const double n = index_of_aqueous;
    Mat4 matrix = Mat4::Zero();
    matrix(0, 0) = n;
    matrix(1, 1) = n;
    matrix(3, 2) = power;
    matrix(3, 3) = n - power * apex_z;
    matrix(2, 2) = apex_z * power + 1.0;
    matrix(2, 3) = apex_z * (n - power * apex_z) - apex_z;
    return matrix;
}

/// The inverse map, applied to a point.
Vec4 behind_cornea(const Vec3& point, double apex_z, double power) {
    const double depth = apex_z - point.z();
    const double scale = 1.0 + power * depth;
    return {point.x(), point.y(), apex_z * scale - index_of_aqueous * depth, scale};
}

Vec3 outside_direction(const View& view, double x, double y) { return view.forward + x * view.right + y * view.up; }

}  // namespace

View view_in_air(const Camera& camera, int width, int height) {
    View view;
    view.width = width;
    view.height = height;
    const Vec3 toward = camera.target - camera.eye;
    const double distance = std::max(toward.norm(), 1e-6);
    view.axis = toward / distance;
    const Vec3 right = right_of(view.axis, camera.up);
    const Vec3 up = right.cross(view.axis);
    // an eye beside the other looks straight ahead through a window that is not before it: nothing is turned
    const double lean = camera.aside_mm / distance;
    view.eye = camera.eye + camera.aside_mm * right;
    view.forward = view.axis - lean * right;
    const double tan_y = 0.5 * camera.field_mm / distance;
    const double tan_x = tan_y * width / height;
    view.right = tan_x * right;
    view.up = tan_y * up;
    const double near = std::max(0.02 * distance, distance - reach);
    Mat4 window = Mat4::Identity();
    window(0, 2) = lean;
    view.clip_from_world =
        projection(tan_x, tan_y, near, distance + reach) * window * placement(view.eye, right, up, view.axis);
    view.plane_point = camera.target;
    view.centre << view.eye, 1.0;
    return view;
}

View view_through_cornea(const Camera& camera, int width, int height, const EyeAnatomy& eye) {
    View view = view_in_air(camera, width, height);
    const double power = corneal_power(eye);
    view.clip_from_world = view.clip_from_world * corneal_image(eye.cornea_apex_z, power);
    view.axis = -Vec3::UnitZ();
    view.plane_point = Vec3(0.0, 0.0, eye.cornea_apex_z);
    view.centre = behind_cornea(view.eye, eye.cornea_apex_z, power);
    return view;
}

Ray pixel_ray(const View& view, int x, int y) {
    const double ndc_x = 2.0 * (x + 0.5) / view.width - 1.0;
    const double ndc_y = 1.0 - 2.0 * (y + 0.5) / view.height;
    const Vec3 outside = outside_direction(view, ndc_x, ndc_y);
    const double along = (view.plane_point - view.eye).dot(view.axis) / outside.dot(view.axis);
    Ray ray;
    ray.at_plane = view.eye + along * outside;
    Vec3 direction = view.centre.w() * ray.at_plane - view.centre.head<3>();
    if (direction.dot(view.axis) < 0.0) {
        direction = -direction;
    }
    ray.direction = direction.normalized();
    ray.stretch = 1.0 / ray.direction.dot(view.axis);
    return ray;
}

double pixel_mm(const View& view, const Vec3& point) {
    return 2.0 * view.up.norm() * (point - view.eye).dot(view.forward) / view.height;
}

Vec2 pixel_of(const View& view, const Vec3& point) {
    const Vec4 clip = view.clip_from_world * point.homogeneous();
    return {0.5 * (1.0 + clip.x() / clip.w()) * view.width, 0.5 * (1.0 - clip.y() / clip.w()) * view.height};
}

}  // namespace rhexis
