// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/tool_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rhexis {

SurfaceDistance cone_distance(const RoundedCone& cone, const Vec3& point) {
    const Vec3 axis = cone.b - cone.a;
    const Vec3 from_a = point - cone.a;
    const double length = axis.norm();
    const double taper = cone.radius_a - cone.radius_b;
    double s = 0.0;  // along the axis, in lengths
    if (length > std::abs(taper)) {
        const double along = from_a.dot(axis) / length;
        const double across = std::sqrt(std::max(0.0, from_a.squaredNorm() - along * along));
        const double tangent = taper / std::sqrt(length * length - taper * taper);
        s = std::clamp((along - across * tangent) / length, 0.0, 1.0);
    } else if (taper < 0.0) {
        s = 1.0;  // one end swallows the other
    }
    const Vec3 from_centre = from_a - s * axis;
    const double distance = from_centre.norm();
    SurfaceDistance result;
    result.distance = distance - (cone.radius_a - s * taper);
    result.normal = distance > 0.0 ? Vec3(from_centre / distance) : Vec3::UnitZ();
    return result;
}

namespace {

/// Whether a part is surely no nearer to a point than `distance`: by its axis and its greater radius, without a root.
bool no_nearer(const RoundedCone& part, const Vec3& point, double distance) {
    const double reach = distance + std::max(part.radius_a, part.radius_b);
    const Vec3 axis = part.b - part.a;
    const Vec3 from_a = point - part.a;
    const double square = axis.squaredNorm();
    const double s = square > 0.0 ? std::clamp(from_a.dot(axis) / square, 0.0, 1.0) : 0.0;
    return reach > 0.0 && (from_a - s * axis).squaredNorm() >= reach * reach;
}

}  // namespace

SurfaceDistance tool_distance(const ToolModel& tool, const Vec3& point, double least_radius) {
    SurfaceDistance nearest;
    nearest.distance = HUGE_VAL;
    for (const RoundedCone& part : tool.parts) {
        const RoundedCone thick{part.a, part.b, std::max(part.radius_a, least_radius),
                                std::max(part.radius_b, least_radius)};
        if (no_nearer(thick, point, nearest.distance)) {
            continue;
        }
        const SurfaceDistance distance = cone_distance(thick, point);
        if (distance.distance < nearest.distance) {
            nearest = distance;
        }
    }
    return nearest;
}

Pose pose_within(const ToolState& tool, double s) {
    if (s >= 1.0) {
        return tool.pose;
    }
    const Quat& from = tool.previous_pose.orientation;
    const Quat& to = tool.pose.orientation;
    const double sign = from.dot(to) < 0.0 ? -1.0 : 1.0;
    Pose pose;
    pose.position = (1.0 - s) * tool.previous_pose.position + s * tool.pose.position;
    pose.orientation.coeffs() = (1.0 - s) * from.coeffs() + sign * s * to.coeffs();
    pose.orientation.normalize();
    return pose;
}

ToolState part_of_step(const ToolState& tool, double from, double to) {
    ToolState part = tool;
    part.previous_pose = pose_within(tool, from);
    part.pose = pose_within(tool, to);
    return part;
}

void Box::add(const Vec3& point, double radius) {
    low = low.cwiseMin(point - Vec3::Constant(radius));
    high = high.cwiseMax(point + Vec3::Constant(radius));
}

double travel(const ToolModel& model, const ToolState& tool) {
    double farthest = 0.0;
    for (const RoundedCone& part : model.parts) {
        for (const Vec3& end : {part.a, part.b}) {
            farthest = std::max(farthest, (tool.pose.to_world(end) - tool.previous_pose.to_world(end)).norm());
        }
    }
    return farthest;
}

namespace {

constexpr double beside_box = 0.5;    // what is near one [mm]
constexpr double beside_nodes = 0.8;  // more than from any place to the nearest node [mm]
constexpr int looks_along = 8;        // at the way of an instrument in a step

/// Shares of the way from a to b between which it lies in a box; first > second where it does not.
std::pair<double, double> shares_within(const Box& box, const Vec3& a, const Vec3& b) {
    double first = 0.0;
    double last = 1.0;
    for (Eigen::Index k = 0; k < 3; ++k) {
        const double way = b[k] - a[k];
        if (way == 0.0) {
            if (a[k] < box.low[k] || a[k] > box.high[k]) {
                return {1.0, 0.0};
            }
            continue;
        }
        const double enters = ((way > 0.0 ? box.low[k] : box.high[k]) - a[k]) / way;
        const double leaves = ((way > 0.0 ? box.high[k] : box.low[k]) - a[k]) / way;
        first = std::max(first, enters);
        last = std::min(last, leaves);
    }
    return {first, last};
}

bool overlap(const Box& a, const Box& b) {
    return (a.low.array() <= b.high.array()).all() && (a.high.array() >= b.low.array()).all();
}

}  // namespace

double travel_near(const ToolModel& model, const ToolState& tool, const Box& box) {
    if (!overlap(swept_box(model, tool), box)) {
        return 0.0;
    }
    if ((tool.pose.position - tool.previous_pose.position).norm() > looks_along * beside_box) {
        return travel(model, tool);
    }
    double farthest = 0.0;
    for (int look = 0; look <= looks_along; ++look) {
        const Pose pose = pose_within(tool, static_cast<double>(look) / looks_along);
        for (const RoundedCone& part : model.parts) {
            const double near = std::max(part.radius_a, part.radius_b) + beside_box;
            const Box wide{box.low - Vec3::Constant(near), box.high + Vec3::Constant(near)};
            const auto [first, last] = shares_within(wide, pose.to_world(part.a), pose.to_world(part.b));
            for (const double share : {first, last}) {
                const Vec3 own = part.a + share * (part.b - part.a);
                if (first <= last) {
                    farthest = std::max(farthest, (tool.pose.to_world(own) - tool.previous_pose.to_world(own)).norm());
                }
            }
        }
    }
    return farthest;
}

Box swept_box(const ToolModel& model, const ToolState& tool) {
    Box box;
    for (const RoundedCone& part : model.parts) {
        for (const Pose& pose : {tool.previous_pose, tool.pose}) {
            // The end of a turning part leaves its chord by at most a fifth of it for turns up to a right angle.
            const double slack = 0.21 * travel(model, tool);
            box.add(pose.to_world(part.a), part.radius_a + slack);
            box.add(pose.to_world(part.b), part.radius_b + slack);
        }
    }
    return box;
}

bool comes_near(const ToolModel& model, const ToolState& tool, double travel, const std::vector<Vec3>& nodes) {
    for (const RoundedCone& part : model.parts) {
        const double reach = std::max(part.radius_a, part.radius_b) + travel + beside_nodes;
        const Vec3 a = tool.pose.to_world(part.a);
        const Vec3 along = tool.pose.to_world(part.b) - a;
        const double square = along.squaredNorm();
        for (const Vec3& node : nodes) {
            const double share = square > 0.0 ? std::clamp(along.dot(node - a) / square, 0.0, 1.0) : 0.0;
            if ((a + share * along - node).squaredNorm() < reach * reach) {
                return true;
            }
        }
    }
    return false;
}

double thinnest(const ToolModel& model) {
    double radius = HUGE_VAL;
    for (const RoundedCone& part : model.parts) {
        radius = std::min({radius, part.radius_a, part.radius_b});
    }
    return radius;
}

}  // namespace rhexis
