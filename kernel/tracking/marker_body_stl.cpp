// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/marker_body_stl.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/numbers.hpp"

namespace rhexis::tracking {
namespace {

constexpr int sectors = 48;    ///< of a surface of revolution
constexpr int arc_points = 9;  ///< of a quarter of a circle, and of a seat
constexpr double quarter = 1.5707963267948966;

using Triangle = std::array<Vec3, 3>;

/// Distance from the axis and height above where it begins.
struct ProfilePoint {
    double radius;
    double height;
};

struct Axis {
    Vec3 from;
    Vec3 along;  ///< unit
};

/// Corners of a ring of a surface of revolution; all alike on the axis.
std::array<Vec3, sectors> ring_of(const Axis& axis, const ProfilePoint& point) {
    const Vec3 across = axis.along.unitOrthogonal();
    const Vec3 beside = axis.along.cross(across);
    std::array<Vec3, sectors> ring;
    for (int i = 0; i < sectors; ++i) {
        const double angle = 4.0 * quarter * i / sectors;
        ring[static_cast<std::size_t>(i)] = axis.from + point.height * axis.along +
                                            point.radius * (std::cos(angle) * across + std::sin(angle) * beside);
    }
    return ring;
}

/// Between two rings; a side on the axis has no width, and gives no triangle.
void add_band(const Axis& axis, const ProfilePoint& low, const ProfilePoint& high, std::vector<Triangle>& solid) {
    const std::array<Vec3, sectors> lower = ring_of(axis, low);
    const std::array<Vec3, sectors> upper = ring_of(axis, high);
    for (std::size_t i = 0; i < sectors; ++i) {
        const std::size_t next = (i + 1) % sectors;
        if (low.radius > 0.0) {
            solid.push_back({lower[i], lower[next], upper[next]});
        }
        if (high.radius > 0.0) {
            solid.push_back({lower[i], upper[next], upper[i]});
        }
    }
}

/// Revolves a profile that has its solid on its left as it goes; closed: its ends lie on the axis, or it is a loop.
void add_revolved(const Axis& axis, const std::vector<ProfilePoint>& profile, std::vector<Triangle>& solid) {
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        add_band(axis, profile[i], profile[i + 1], solid);
    }
}

void add_ring(const Axis& axis, const MarkerBodyPrint& print, std::vector<Triangle>& solid) {
    const double inner = print.shaft_radius + print.clearance;
    const double outer = inner + print.ring_wall;
    const double half = 0.5 * print.ring_width;
    add_revolved(axis, {{inner, -half}, {outer, -half}, {outer, half}, {inner, half}, {inner, -half}}, solid);
}

/// A bar with round ends, whose centres are these.
void add_bar(const Vec3& from, const Vec3& to, double radius, std::vector<Triangle>& solid) {
    const double length = (to - from).norm();
    std::vector<ProfilePoint> profile{{0.0, -radius}};
    for (int i = 1; i <= arc_points; ++i) {
        const double angle = quarter * i / arc_points;
        profile.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
    }
    for (int i = arc_points; i >= 1; --i) {
        const double angle = quarter * i / arc_points;
        profile.push_back({radius * std::sin(angle), length + radius * std::cos(angle)});
    }
    profile.push_back({0.0, length + radius});
    add_revolved({from, (to - from) / length}, profile, solid);
}

void add_post(const Vec3& from, const Vec3& marker, double seat_radius, const MarkerBodyPrint& print,
              std::vector<Triangle>& solid) {
    const double length = (marker - from).norm();
    const double bottom = length - seat_radius;
    std::vector<ProfilePoint> profile{{0.0, 0.0}, {print.post_radius, 0.0}};
    for (int i = 0; i <= arc_points; ++i) {
        const double radius = print.post_radius + (print.pin_radius - print.post_radius) * i / arc_points;
        profile.push_back({radius, length - std::sqrt(seat_radius * seat_radius - radius * radius)});
    }
    profile.push_back({print.pin_radius, bottom + print.pin_length});
    profile.push_back({0.0, bottom + print.pin_length});
    add_revolved({from, (marker - from) / length}, profile, solid);
}

Status check_sizes(const MarkerBody& body, const MarkerBodyPrint& print, const std::string& where) {
    const double most_pin = std::min(5.0, 0.95 * print.post_radius);
    for (const Status& status :
         {check_range("shaft_radius", print.shaft_radius, 0.5, 50.0, where, "mm"),
          check_range("clearance", print.clearance, 0.0, 1.0, where, "mm"),
          check_range("ring_width", print.ring_width, 2.0, 50.0, where, "mm"),
          check_range("ring_wall", print.ring_wall, 1.0, 10.0, where, "mm"),
          check_range("bar_radius", print.bar_radius, 1.0, std::min(10.0, print.ring_wall), where, "mm"),
          check_range("radius_mm", body.radius_mm, 0.5, 20.0, where, "mm"),
          check_range("post_radius", print.post_radius, 1.2, std::min(10.0, 0.9 * body.radius_mm), where, "mm"),
          check_range("pin_radius", print.pin_radius, 0.2, most_pin, where, "mm"),
          check_range("pin_length", print.pin_length, 0.5, std::min(10.0, body.radius_mm), where, "mm")}) {
        if (!status) {
            return status;
        }
    }
    if (body.markers.empty()) {
        return Error{"no markers", where, "3 to 8"};
    }
    return success();
}

/// Where ring, bar and posts begin.
struct PrintPlan {
    Axis shaft;
    Vec3 bar_from;
    Vec3 hub;  ///< where all posts begin
};

PrintPlan plan_of(const MarkerBody& body, const MarkerBodyPrint& print) {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& marker : body.markers) {
        mean += marker / static_cast<double>(body.markers.size());
    }
    const Vec3 along = body.tip.orientation * Vec3::UnitZ();
    const Vec3 foot = body.tip.position + along * along.dot(mean - body.tip.position);
    const Vec3 off = mean - foot;
    const double outer = print.shaft_radius + print.clearance + print.ring_wall;
    const Vec3 beside = off.norm() > 1e-6 ? Vec3(off.normalized()) : Vec3(along.unitOrthogonal());
    const double reach = std::max(off.norm(), outer + print.bar_radius);
    return {{foot, along}, foot + outer * beside, foot + reach * beside};
}

double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
    const Vec3 line = to - from;
    const double share = std::clamp(line.dot(point - from) / line.squaredNorm(), 0.0, 1.0);
    return (from + share * line - point).norm();
}

/// Least distance of a segment to a line: convex in the place along the segment, and squared a parabola.
double distance_to_line(const Axis& line, const Vec3& from, const Vec3& to) {
    const Vec3 start = (from - line.from) - line.along * line.along.dot(from - line.from);
    const Vec3 end = (to - line.from) - line.along * line.along.dot(to - line.from);
    if ((end - start).squaredNorm() < 1e-18) {
        return start.norm();
    }
    return distance_to_segment(Vec3::Zero(), start, end);
}

Status check_post(const MarkerBody& body, std::size_t marker, const PrintPlan& plan, const MarkerBodyPrint& print,
                  const std::string& where) {
    const std::string name = "the post of marker " + std::to_string(marker + 1);
    const Vec3& at = body.markers[marker];
    const double shortest = body.radius_mm + print.clearance + print.bar_radius;
    if (!at.allFinite() || distance_to_segment(at, plan.bar_from, plan.hub) < shortest) {
        return Error{name + " has no room", where,
                     "markers at least " + short_number(shortest) +
                         " mm from the bar that leads from the shaft to the markers' mean"};
    }
    if (distance_to_line(plan.shaft, plan.hub, at) < print.shaft_radius + print.post_radius) {
        return Error{name + " meets the shaft", where, "markers to one side of the shaft"};
    }
    for (std::size_t other = 0; other < body.markers.size(); ++other) {
        if (other != marker &&
            distance_to_segment(body.markers[other], plan.hub, at) < body.radius_mm + print.post_radius) {
            return Error{name + " meets the sphere of marker " + std::to_string(other + 1), where,
                         "markers that are seen from their mean in different directions"};
        }
    }
    return success();
}

void append_word(std::uint32_t word, int bytes, std::string& out) {
    for (int i = 0; i < bytes; ++i) {
        out.push_back(static_cast<char>(static_cast<unsigned char>(word >> (8 * i))));
    }
}

void append_vector(const Vec3& vector, std::string& out) {
    for (int i = 0; i < 3; ++i) {
        append_word(std::bit_cast<std::uint32_t>(static_cast<float>(vector[i])), 4, out);
    }
}

/// 80 bytes that say nothing, a count, and for each triangle its normal, corners and two bytes more.
std::string binary_stl(const std::vector<Triangle>& solid) {
    std::string out = "marker body, millimetres";
    out.resize(80, ' ');
    append_word(static_cast<std::uint32_t>(solid.size()), 4, out);
    for (const Triangle& triangle : solid) {
        append_vector((triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized(), out);
        for (const Vec3& corner : triangle) {
            append_vector(corner, out);
        }
        append_word(0, 2, out);
    }
    return out;
}

}  // namespace

Result<std::string> marker_body_stl(const MarkerBody& body, const MarkerBodyPrint& print) {
    const std::string where = "body \"" + body.name + "\"";
    if (const Status status = check_sizes(body, print, where); !status) {
        return status.error();
    }
    const PrintPlan plan = plan_of(body, print);
    std::vector<Triangle> solid;
    add_ring(plan.shaft, print, solid);
    add_bar(plan.bar_from, plan.hub, print.bar_radius, solid);
    for (std::size_t i = 0; i < body.markers.size(); ++i) {
        if (const Status status = check_post(body, i, plan, print, where); !status) {
            return status.error();
        }
        add_post(plan.hub, body.markers[i], body.radius_mm + print.clearance, print, solid);
    }
    return binary_stl(solid);
}

}  // namespace rhexis::tracking
