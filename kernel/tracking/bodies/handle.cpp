// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/bodies/handle.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::tracking {
namespace {

constexpr double off_line_mm = 0.1;  ///< that an end of a cone in line with the handle may be off its axis

double off_axis(const Handle& handle, const Vec3& point) {
    const Vec3 way = point - handle.foot;
    return (way - way.dot(handle.along) * handle.along).norm();
}

double behind(const Handle& handle, const Vec3& point) { return (point - handle.foot).dot(handle.along); }

/// Whose end is the farthest from the tip; none: all are short.
const RoundedCone* farthest_of(std::span<const RoundedCone> cones) {
    constexpr double shortest_mm = 1.0;
    const RoundedCone* farthest = nullptr;
    const auto reach = [](const RoundedCone& cone) { return std::max(cone.a.norm(), cone.b.norm()); };
    for (const RoundedCone& cone : cones) {
        if ((cone.b - cone.a).norm() >= shortest_mm && (farthest == nullptr || reach(cone) > reach(*farthest))) {
            farthest = &cone;
        }
    }
    return farthest;
}

}  // namespace

Result<Handle> handle_of(std::span<const RoundedCone> cones, const std::string& where) {
    const RoundedCone* last = farthest_of(cones);
    if (last == nullptr) {
        return Error{"it has no handle", where, "a straight part of at least 1 mm"};
    }
    const bool forwards = last->b.norm() >= last->a.norm();
    Handle handle;
    handle.along = (forwards ? last->b - last->a : last->a - last->b).normalized();
    handle.foot = last->a - last->a.dot(handle.along) * handle.along;
    handle.from_mm = handle.to_mm = behind(handle, forwards ? last->b : last->a);
    for (const RoundedCone& cone : cones) {
        const bool in_line = std::max(off_axis(handle, cone.a), off_axis(handle, cone.b)) < off_line_mm;
        (in_line ? handle.on : handle.off).push_back(cone);
        if (in_line) {
            handle.from_mm = std::min({handle.from_mm, behind(handle, cone.a), behind(handle, cone.b)});
        }
    }
    return handle;
}

Handle moved_to(const Pose& pose, Handle handle) {
    handle.foot = pose.to_world(handle.foot);
    handle.along = pose.orientation * handle.along;
    for (std::vector<RoundedCone>* cones : {&handle.on, &handle.off}) {
        for (RoundedCone& cone : *cones) {
            cone.a = pose.to_world(cone.a);
            cone.b = pose.to_world(cone.b);
        }
    }
    return handle;
}

double greatest_radius(const Handle& handle, double from_mm, double to_mm) {
    double greatest = 0.0;
    for (const RoundedCone& cone : handle.on) {
        const double a = behind(handle, cone.a);
        const double b = behind(handle, cone.b);
        const auto [low, high] = std::minmax(a, b);
        if (high < from_mm || low > to_mm) {
            continue;
        }
        for (const double place : {std::max(low, from_mm), std::min(high, to_mm)}) {
            const double share = std::abs(b - a) > 1e-9 ? (place - a) / (b - a) : 0.0;
            greatest = std::max(greatest, cone.radius_a + share * (cone.radius_b - cone.radius_a));
        }
    }
    return greatest;
}

}  // namespace rhexis::tracking
