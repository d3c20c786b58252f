// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/half_ellipsoids.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rhexis {

namespace {

double half_axis(const HalfEllipsoids& shape, double z) { return z >= 0.0 ? shape.anterior : shape.posterior; }

/// In the meridian plane: rho >= 0 from the axis, z >= 0 from the equator.
struct Meridian {
    double distance = 0.0;
    double normal_rho = 0.0;
    double normal_z = 1.0;
};

/// Closest point of the quarter ellipse rho^2 / a^2 + z^2 / c^2 = 1. With the foot point q = (a^2 rho / (t + a^2),
/// c^2 z / (t + c^2)), t is the largest root of F(t) = |q scaled|^2 - 1, which is convex and falling; so Newton from
/// any start where F >= 0 climbs to the root without overshoot, and one step from a start with F < 0 lands there.
Meridian closest_on_quarter(double a, double c, double rho, double z) {
    const double lowest = std::max(-a * a + a * rho, -c * c + c * z);  // F >= 0 there
    const double first = std::min(a * a, c * c);
    if (lowest + first <= 1e-14 * first) {
        // The point is inside on the longer axis, where the foot point is not unique in z or rho: solve directly.
        const bool flat = c <= a;
        const double along = flat ? rho : z;
        const double big = flat ? a : c;
        const double small = flat ? c : a;
        const double foot = big > small ? std::min(big * big * along / (big * big - small * small), big) : 0.0;
        const double height = small * std::sqrt(std::max(0.0, 1.0 - foot * foot / (big * big)));
        const double foot_rho = flat ? foot : height;
        const double foot_z = flat ? height : foot;
        const double n_rho = foot_rho / (a * a);
        const double n_z = foot_z / (c * c);
        const double length = std::sqrt(n_rho * n_rho + n_z * n_z);
        return {-std::sqrt((rho - foot_rho) * (rho - foot_rho) + (z - foot_z) * (z - foot_z)), n_rho / length,
                n_z / length};
    }
    double t = std::max(0.0, lowest);
    for (int iteration = 0; iteration < 60; ++iteration) {
        const double u = a * rho / (t + a * a);
        const double v = c * z / (t + c * c);
        const double value = u * u + v * v - 1.0;
        const double slope = -2.0 * (u * u / (t + a * a) + v * v / (t + c * c));
        const double next = std::max(lowest, t - value / slope);
        const bool done = std::abs(next - t) <= 1e-15 * (a * a + std::abs(t));
        t = next;
        if (done) {
            break;
        }
    }
    const double n_rho = rho / (t + a * a);
    const double n_z = z / (t + c * c);
    const double length = std::sqrt(n_rho * n_rho + n_z * n_z);
    return {t * length, n_rho / length, n_z / length};
}

}  // namespace

double surface_level(const HalfEllipsoids& shape, const Vec3& point) {
    const double x = point.x() / shape.radius;
    const double y = point.y() / shape.radius;
    const double z = point.z() / half_axis(shape, point.z());
    return std::sqrt(x * x + y * y + z * z);
}

Vec3 onto_surface(const HalfEllipsoids& shape, const Vec3& point) { return point / surface_level(shape, point); }

double shape_volume(const HalfEllipsoids& shape) {
    return 2.0 / 3.0 * std::numbers::pi * shape.radius * shape.radius * (shape.anterior + shape.posterior);
}

SurfacePoint closest_on(const HalfEllipsoids& shape, const Vec3& point) {
    const double rho = std::sqrt(point.x() * point.x() + point.y() * point.y());
    const bool above = point.z() >= 0.0;
    const Meridian best = closest_on_quarter(shape.radius, half_axis(shape, point.z()), rho, std::abs(point.z()));
    const double side = above ? 1.0 : -1.0;
    const Vec3 radial = rho > 0.0 ? Vec3(point.x() / rho, point.y() / rho, 0.0) : Vec3(1.0, 0.0, 0.0);
    const Vec3 normal = best.normal_rho * radial + side * best.normal_z * Vec3::UnitZ();
    return {best.distance, normal};
}

}  // namespace rhexis
