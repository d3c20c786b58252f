// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/scene.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::tracking::synthetic {
namespace {

double share_of(double part, double whole) { return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0; }

}  // namespace

double smooth_step(double x) {
    const double within = std::clamp(x, 0.0, 1.0);
    return within * within * (3.0 - 2.0 * within);
}

Nearest nearest(const Vec3& from, const Vec3& to, const Vec3& other_from, const Vec3& other_to) {
    const Vec3 first = to - from;
    const Vec3 second = other_to - other_from;
    const Vec3 between = from - other_from;
    const double first2 = first.squaredNorm();
    const double second2 = second.squaredNorm();
    const double mixed = first.dot(second);
    const double off_first = first.dot(between);
    const double off_second = second.dot(between);
    Nearest result;
    result.along_first = share_of(mixed * off_second - off_first * second2, first2 * second2 - mixed * mixed);
    result.along_second = share_of(off_second + result.along_first * mixed, second2);
    // the second was clamped to its ends: the first is sought again for where it is now
    result.along_first = share_of(result.along_second * mixed - off_first, first2);
    result.distance = (between + result.along_first * first - result.along_second * second).norm();
    return result;
}

double light_past(const Capsule& capsule, const Vec3& eye, const Vec3& point) {
    const double distance = nearest(eye, point, capsule.from, capsule.to).distance;
    return smooth_step((distance - capsule.radius) / capsule.soft + 0.5);
}

double light_past(const Disc& disc, const Vec3& eye, const Vec3& point) {
    const double before = disc.normal.dot(disc.centre - eye);
    const double behind = disc.normal.dot(disc.centre - point);
    if (before * behind >= 0.0) {
        return 1.0;
    }
    const Vec3 through = eye + before / (before - behind) * (point - eye);
    return smooth_step(((through - disc.centre).norm() - disc.radius) / disc.soft + 0.5);
}

bool may_hide(const Capsule& capsule, const Vec3& eye, const Vec3& centre, double radius) {
    const double reach = capsule.radius + 0.5 * capsule.soft + radius;
    return nearest(eye, centre, capsule.from, capsule.to).distance < reach;
}

bool may_hide(const Disc& disc, const Vec3& eye, const Vec3& centre, double radius) {
    const double reach = disc.radius + 0.5 * disc.soft + radius;
    return nearest(eye, centre, disc.centre, disc.centre).distance < reach;
}

}  // namespace rhexis::tracking::synthetic
