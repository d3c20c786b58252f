// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/camera.hpp"

#include "tracking/lens_model.hpp"

namespace rhexis::tracking {
namespace {

/// Distortion of a direction, and its derivative.
struct Bent {
    Vec2 at;
    Mat2 slope;
};

Bent bent(const Lens& lens, const Vec2& direction) {
    const double x = direction.x();
    const double y = direction.y();
    const double r2 = x * x + y * y;
    const double radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
    const double radial_slope = lens.k1 + r2 * (2.0 * lens.k2 + 3.0 * r2 * lens.k3);  // d radial / d r2
    Bent result;
    result.at = bent_direction(numbers_of(lens).data(), direction);
    result.slope << radial + 2.0 * x * x * radial_slope + 2.0 * lens.p1 * y + 6.0 * lens.p2 * x,
        2.0 * x * y * radial_slope + 2.0 * lens.p1 * x + 2.0 * lens.p2 * y,
        2.0 * x * y * radial_slope + 2.0 * lens.p1 * x + 2.0 * lens.p2 * y,
        radial + 2.0 * y * y * radial_slope + 6.0 * lens.p1 * y + 2.0 * lens.p2 * x;
    return result;
}

}  // namespace

Vec2 distorted(const Lens& lens, const Vec2& direction) { return lens_image(numbers_of(lens).data(), direction); }

Vec2 undistorted(const Lens& lens, const Vec2& pixel) {
    constexpr int most_steps = 12;
    constexpr double enough = 1e-12;  // of a direction: less than a millionth of a pixel
    const Vec2 wanted{(pixel.x() - lens.cx) / lens.fx, (pixel.y() - lens.cy) / lens.fy};
    Vec2 direction = wanted;
    Vec2 best = direction;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_steps; ++i) {
        const Bent now = bent(lens, direction);
        const Vec2 off = now.at - wanted;
        if (off.norm() < least) {
            least = off.norm();
            best = direction;
        }
        if (least < enough || now.slope.determinant() < 0.1) {
            break;
        }
        direction -= now.slope.inverse() * off;
    }
    return best;
}

std::optional<Vec2> project(const Camera& camera, const Vec3& point) {
    const Vec3 seen = camera.pose.to_body(point);
    if (seen.z() <= 0.0) {
        return std::nullopt;
    }
    return distorted(camera.lens, seen.head<2>() / seen.z());
}

Eigen::Matrix<double, 2, 3> projection_slope(const Lens& lens, const Vec3& in_camera) {
    const Vec2 direction = in_camera.head<2>() / in_camera.z();
    Eigen::Matrix<double, 2, 3> central;
    central << 1.0, 0.0, -direction.x(), 0.0, 1.0, -direction.y();
    Mat2 scaled = bent(lens, direction).slope;
    scaled.row(0) *= lens.fx;
    scaled.row(1) *= lens.fy;
    return scaled * central / in_camera.z();
}

Ray ray_of(const Camera& camera, const Vec2& pixel) {
    const Vec2 direction = undistorted(camera.lens, pixel);
    return {camera.pose.position, (camera.pose.orientation * Vec3(direction.x(), direction.y(), 1.0)).normalized()};
}

}  // namespace rhexis::tracking
