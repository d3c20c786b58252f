// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/true_camera.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::tracking::synthetic {
namespace {

/// Of a direction, before the focal length.
Vec2 bent_direction(const TrueLens& lens, const Vec2& direction) {
    const double x = direction.x();
    const double y = direction.y();
    const double r2 = x * x + y * y;
    const double radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
    return {x * radial + 2.0 * lens.p1 * x * y + lens.p2 * (r2 + 2.0 * x * x) + r2 * (lens.s[0] + r2 * lens.s[1]),
            y * radial + lens.p1 * (r2 + 2.0 * y * y) + 2.0 * lens.p2 * x * y + r2 * (lens.s[2] + r2 * lens.s[3])};
}

Mat2 bent_slope(const TrueLens& lens, const Vec2& direction) {
    const double r2 = direction.squaredNorm();
    const double radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
    const double by_r2 = lens.k1 + r2 * (2.0 * lens.k2 + 3.0 * r2 * lens.k3);
    const Vec2 decentring{lens.p2, lens.p1};
    const Vec2 prism{lens.s[0] + 2.0 * r2 * lens.s[1], lens.s[2] + 2.0 * r2 * lens.s[3]};
    Mat2 slope = (radial + 2.0 * (lens.p1 * direction.y() + lens.p2 * direction.x())) * Mat2::Identity();
    slope += 2.0 * by_r2 * direction * direction.transpose();
    slope += 2.0 * (decentring + prism) * direction.transpose();
    slope += 2.0 * direction * decentring.transpose();
    return slope;
}

}  // namespace

Vec2 distorted(const TrueLens& lens, const Vec2& direction) {
    const Vec2 bent = bent_direction(lens, direction);
    return {lens.fx * bent.x() + lens.cx, lens.fy * bent.y() + lens.cy};
}

Mat2 distortion_slope(const TrueLens& lens, const Vec2& direction) {
    Mat2 slope = bent_slope(lens, direction);
    slope.row(0) *= lens.fx;
    slope.row(1) *= lens.fy;
    return slope;
}

Vec2 undistorted(const TrueLens& lens, const Vec2& pixel) {
    constexpr int most_steps = 8;
    constexpr double enough = 1e-13;
    const Vec2 wanted{(pixel.x() - lens.cx) / lens.fx, (pixel.y() - lens.cy) / lens.fy};
    Vec2 direction = wanted;
    for (int i = 0; i < most_steps; ++i) {
        const Vec2 off = bent_direction(lens, direction) - wanted;
        direction -= bent_slope(lens, direction).inverse() * off;
        if (off.norm() < enough) {
            break;
        }
    }
    return direction;
}

std::optional<Vec2> project(const TrueCamera& camera, const Vec3& point) {
    const Vec3 seen = camera.pose.to_body(point);
    if (seen.z() <= 0.0) {
        return std::nullopt;
    }
    return distorted(camera.lens, seen.head<2>() / seen.z());
}

double psf_sigma(const TrueCamera& camera, const Vec2& pixel, double depth_mm) {
    constexpr double sharpest = 0.5;
    constexpr double widest = 0.9;
    const Vec2 half{0.5 * camera.width, 0.5 * camera.height};
    const double share = (pixel - half).squaredNorm() / half.squaredNorm();
    const double in_focus = camera.optics.psf_px + camera.optics.psf_rim_px * share;
    const double defocus = camera.optics.defocus_px * (1.0 / depth_mm - 1.0 / camera.optics.focus_mm);
    return std::clamp(std::hypot(in_focus, defocus), sharpest, widest);
}

double sensitivity(const Optics& optics, const Vec2& direction) {
    const double share = direction.squaredNorm() / (optics.vignetting_at * optics.vignetting_at);
    return std::max(0.05, 1.0 - optics.vignetting * share);
}

Vec2 sensitivity_slope(const Optics& optics, const Vec2& direction) {
    const double at2 = optics.vignetting_at * optics.vignetting_at;
    return -2.0 * optics.vignetting / at2 / sensitivity(optics, direction) * direction;
}

}  // namespace rhexis::tracking::synthetic
