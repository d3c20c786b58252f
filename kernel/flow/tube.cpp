// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/tube.hpp"

#include <algorithm>
#include <cmath>

#include "base/ranges.hpp"

namespace rhexis {
namespace {

constexpr int refinements = 8;  // of the nearest point of an ellipse: to rounding for axes of up to three to one

/// An ellipse across the axis and its growth along it.
struct Section {
    Vec2 half = Vec2::Zero();
    Vec2 slope = Vec2::Zero();
};

Section section_at(const TubeModel& tube, double z) {
    const auto half = [](const TubeStation& s) { return Vec2(s.half_width, s.half_height); };
    const std::vector<TubeStation>& stations = tube.stations;
    if (z <= stations.front().z) {
        return {half(stations.front()), Vec2::Zero()};
    }
    for (std::size_t i = 1; i < stations.size(); ++i) {
        if (z < stations[i].z) {
            const double length = stations[i].z - stations[i - 1].z;
            const double u = (z - stations[i - 1].z) / length;
            const Vec2 growth = half(stations[i]) - half(stations[i - 1]);
            return {half(stations[i - 1]) + u * u * (3.0 - 2.0 * u) * growth, 6.0 * u * (1.0 - u) / length * growth};
        }
    }
    return {half(stations.back()), Vec2::Zero()};
}

/// The nearest point of an ellipse to one in its first quadrant: again and again that of the circle of curvature there.
Vec2 foot_on_ellipse(const Vec2& half, const Vec2& p) {
    const double a = half.x();
    const double b = half.y();
    if (a == b && p.squaredNorm() > 0.0) {
        return a * p.normalized();
    }
    Vec2 t = Vec2::Constant(std::sqrt(0.5));
    for (int i = 0; i < refinements; ++i) {
        const Vec2 on = half.cwiseProduct(t);
        const Vec2 centre((a * a - b * b) / a * t.x() * t.x() * t.x(), (b * b - a * a) / b * t.y() * t.y() * t.y());
        const Vec2 way = p - centre;
        const double far = way.norm();
        if (!(far > 0.0)) {
            break;
        }
        const Vec2 next = (centre + (on - centre).norm() / far * way).cwiseQuotient(half);
        const Vec2 held = next.cwiseMax(Vec2::Zero()).cwiseMin(Vec2::Ones());
        if (!(held.squaredNorm() > 0.0)) {
            break;
        }
        t = held.normalized();
    }
    return half.cwiseProduct(t);
}

/// Signed distance within the section, positive inside; `out`: unit, in the section; `growth`: of the wall along it.
struct Across {
    double distance = 0.0;
    Vec2 out = Vec2::UnitX();
    double growth = 0.0;
};

Across across(const Section& section, const Vec2& p) {
    const Vec2 foot = foot_on_ellipse(section.half, p.cwiseAbs());
    const Vec2 steep = foot.cwiseQuotient(section.half.cwiseProduct(section.half)).normalized();
    Across result;
    result.distance = steep.dot(foot - p.cwiseAbs());
    result.growth = steep.dot(section.slope.cwiseProduct(foot.cwiseQuotient(section.half)));
    result.out = Vec2(p.x() < 0.0 ? -steep.x() : steep.x(), p.y() < 0.0 ? -steep.y() : steep.y());
    return result;
}

}  // namespace

Status check_tube(const TubeModel& tube) {
    if (tube.stations.empty()) {
        return Error{"stations is empty", tube.name, "one or more"};
    }
    for (std::size_t i = 0; i < tube.stations.size(); ++i) {
        const TubeStation& s = tube.stations[i];
        if (Status status = check_ranges(
                {{"half_width", s.half_width, 0.01, 100.0, " mm"}, {"half_height", s.half_height, 0.01, 100.0, " mm"}},
                tube.name);
            !status) {
            return status;
        }
        if (i > 0 && !(s.z > tube.stations[i - 1].z)) {
            return Error{std::string("z of station ").append(std::to_string(i)).append(" is not above that before it"),
                         tube.name, "ascending z"};
        }
    }
    return check_ranges({{"lip", tube.lip, 1e-3, 10.0, " mm"}, {"friction", tube.friction, 0.0, 10.0, ""}}, tube.name);
}

bool within_bore(const TubeModel& tube, const Vec3& point) {
    const Section section = section_at(tube, point.z());
    return point.z() < tube.stations.back().z && point.head<2>().cwiseQuotient(section.half).squaredNorm() < 1.0;
}

SurfaceDistance tube_distance(const TubeModel& tube, const Vec3& point) {
    const double lip_z = tube.stations.back().z - tube.lip;
    const Section section = section_at(tube, std::min(point.z(), lip_z));
    const Across found = across(section, point.head<2>());
    const double to_middle = found.distance + tube.lip;  // of the wall, negative beyond it
    if (point.z() > lip_z) {
        const double beyond = point.z() - lip_z;
        const double far = std::sqrt(to_middle * to_middle + beyond * beyond);
        const Vec2 in = -to_middle / far * found.out;
        return {far - tube.lip, Vec3(in.x(), in.y(), beyond / far)};
    }
    const double side = to_middle < 0.0 ? -1.0 : 1.0;
    const double cosine = 1.0 / std::sqrt(1.0 + found.growth * found.growth);
    const Vec2 in = -side * cosine * found.out;
    return {cosine * (side * to_middle - tube.lip), Vec3(in.x(), in.y(), side * cosine * found.growth)};
}

}  // namespace rhexis
