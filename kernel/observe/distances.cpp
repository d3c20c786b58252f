// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/distances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rhexis {
namespace {

/// Least value of a function on [0, 1]: the best of evenly spread samples, refined by golden sections.
template <typename Function>
double least_on_unit(int samples, const Function& f) {
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= samples; ++i) {
        const double value = f(static_cast<double>(i) / samples);
        if (value < least) {
            least = value;
            best = i;
        }
    }
    constexpr double golden = 0.6180339887498949;
    double low = static_cast<double>(std::max(0, best - 1)) / samples;
    double high = static_cast<double>(std::min(samples, best + 1)) / samples;
    for (int i = 0; i < 24; ++i) {
        const double a = high - golden * (high - low);
        const double b = low + golden * (high - low);
        if (f(a) < f(b)) {
            high = b;
        } else {
            low = a;
        }
    }
    return std::min(least, f(0.5 * (low + high)));
}

double radius_of(const Vec3& point) { return std::sqrt(point.x() * point.x() + point.y() * point.y()); }

/// From (r, z) to the rim of the anterior opening.
double rim_distance(const BagModel& bag, double r, double z) {
    const double share = bag.opening_radius / bag.shape.radius;
    const double rim_z = bag.shape.anterior * std::sqrt(std::max(0.0, 1.0 - share * share));
    return std::sqrt((r - bag.opening_radius) * (r - bag.opening_radius) + (z - rim_z) * (z - rim_z));
}

}  // namespace

double posterior_distance(const BagShape& shape, const Vec3& point) {
    const double r = radius_of(point);
    const double least = least_on_unit(24, [&](double u) {
        const double scale = 1.0 / (1.0 + u * u);  // (cos, sin) of the meridian angle without a library function
        const double dr = shape.radius * (1.0 - u * u) * scale - r;
        const double dz = -shape.posterior * 2.0 * u * scale - point.z();
        return dr * dr + dz * dz;
    });
    return std::sqrt(least);
}

double bag_wall_distance(const BagModel& bag, const Vec3& point) {
    const SurfaceDistance nearest = bag_distance(bag.shape, point);
    const Vec3 foot = point - nearest.distance * nearest.normal;
    if (foot.z() <= 0.0 || radius_of(foot) >= bag.opening_radius) {
        return std::abs(nearest.distance);
    }
    return std::min(posterior_distance(bag.shape, point), rim_distance(bag, radius_of(point), point.z()));
}

double iris_distance(const EyeAnatomy& eye, const Vec3& point) {
    const double r = radius_of(point);
    const double dr = std::max({0.0, eye.pupil_radius - r, r - eye.limbus_radius});
    const double dz = std::max(0.0, std::abs(point.z() - eye.iris_z) - 0.5 * eye.iris_thickness);
    return std::sqrt(dr * dr + dz * dz);
}

double endothelium_distance(const EyeAnatomy& eye, const Vec3& point) {
    const double centre_z = eye.cornea_apex_z - eye.cornea_thickness - eye.cornea_back_radius;
    const Vec3 from_centre = point - Vec3(0.0, 0.0, centre_z);
    return eye.cornea_back_radius - from_centre.norm();
}

double tool_gap(const ToolModel& model, const Pose& pose, const std::function<double(const Vec3&)>& distance) {
    double gap = std::numeric_limits<double>::infinity();
    for (const RoundedCone& cone : model.parts) {
        const Vec3 a = pose.to_world(cone.a);
        const Vec3 b = pose.to_world(cone.b);
        const double here = least_on_unit(32, [&](double u) {
            const Vec3 point = a + u * (b - a);
            return distance(point) - (cone.radius_a + u * (cone.radius_b - cone.radius_a));
        });
        gap = std::min(gap, here);
    }
    return gap;
}

}  // namespace rhexis
