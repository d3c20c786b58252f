// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/rim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "observe/opening.hpp"
#include "observe/ring_area.hpp"

namespace rhexis {
namespace {

constexpr int samples = 64;
/// Nearer to the axis than this an angle about it says nothing: a slit across the centre has not gone half way round
/// [mm]. No opening is planned as small.
constexpr double core_radius = 1.0;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// As seen along the eye's axis.
std::vector<Vec2> flat(const std::vector<Vec3>& places) {
    std::vector<Vec2> result;
    for (const Vec3& place : places) {
        result.emplace_back(place.head<2>());
    }
    return result;
}

double perimeter_of(const std::vector<Vec2>& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        sum += (ring[(i + 1) % ring.size()] - ring[i]).norm();
    }
    return sum;
}

/// Points evenly along a closed polygon.
std::vector<Vec2> resampled(const std::vector<Vec2>& ring) {
    const double spacing = perimeter_of(ring) / samples;
    std::vector<Vec2> points;
    double passed = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
        const double length = edge.norm();
        while (points.size() < samples && spacing * static_cast<double>(points.size()) < passed + length) {
            const double share = (spacing * static_cast<double>(points.size()) - passed) / length;
            points.emplace_back(ring[i] + share * edge);
        }
        passed += length;
    }
    return points;
}

/// Each point drawn to its neighbours, up to a sixteenth of the way round on either side, the nearer the more.
std::vector<Vec2> smoothed(const std::vector<Vec2>& ring) {
    constexpr int reach = samples / 16;
    const int n = static_cast<int>(ring.size());
    std::vector<Vec2> result;
    for (int i = 0; i < n; ++i) {
        Vec2 sum = Vec2::Zero();
        for (int k = -reach; k <= reach; ++k) {
            sum += (reach - std::abs(k)) * ring[static_cast<std::size_t>((i + k + n) % n)];
        }
        result.emplace_back(sum / (reach * reach));
    }
    return result;
}

/// 4 pi area / perimeter^2, 1 for a circle.
double circularity_of(const std::vector<Vec2>& ring) {
    const double perimeter = perimeter_of(ring);
    return 4.0 * std::numbers::pi * std::abs(ring_area(ring)) / (perimeter * perimeter);
}

Vec2 centroid_of(const std::vector<Vec2>& ring) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2& next = ring[(i + 1) % ring.size()];
        sum += cross(ring[i], next) * (ring[i] + next) / 6.0;
    }
    return sum / ring_area(ring);
}

/// Angle between the ends of a curve about the axis, 0 to 2 pi; what it goes back is taken off again.
double turned_by(const std::vector<Vec2>& curve) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const Vec2 middle = 0.5 * (curve[i] + curve[i + 1]);
        if (middle.norm() > core_radius) {
            sum += std::atan2(cross(curve[i], curve[i + 1]), curve[i].dot(curve[i + 1]));
        }
    }
    return std::min(std::abs(sum), 2.0 * std::numbers::pi);
}

double largest_norm(const std::vector<Vec2>& points) {
    double most = 0.0;
    for (const Vec2& point : points) {
        most = std::max(most, point.norm());
    }
    return most;
}

double smallest_norm(const std::vector<Vec2>& points) {
    double least = HUGE_VAL;
    for (const Vec2& point : points) {
        least = std::min(least, point.norm());
    }
    return least;
}

void measure_tip(const Vec2& place, const Vec2& direction, RhexisShape& shape) {
    shape.tip_radius = place.norm();
    shape.tip_angle = std::atan2(place.y(), place.x());
    if (shape.tip_radius > 0.0 && direction.norm() > 0.0) {
        const Vec2 outward = place / shape.tip_radius;
        shape.tip_heading = std::atan2(direction.dot(outward), std::abs(cross(outward, direction)));
    }
}

constexpr double optic_radius = 3.0;  ///< of a usual implant [mm]

double diameter_of(double area) { return 2.0 * std::sqrt(area / std::numbers::pi); }

void measure_rim(const std::vector<Vec2>& rim, RhexisShape& shape) {
    const std::vector<Vec2> points = resampled(rim);
    const double area = std::abs(ring_area(points));
    if (area > 0.0) {
        shape.mean_diameter = diameter_of(area);
        shape.circularity = circularity_of(smoothed(points));
        shape.centre = centroid_of(points);
        shape.smallest_radius = smallest_norm(points);
        const auto covers = [](const Vec2& point) { return point.norm() < optic_radius; };
        shape.overlap = 2.0 * std::numbers::pi *
                        static_cast<double>(std::count_if(points.begin(), points.end(), covers)) /
                        static_cast<double>(points.size());
    }
}

}  // namespace

RhexisShape rhexis_shape(const MembraneSheet& start, const MembraneState& state, double zonules) {
    const TornOpening opening = find_opening(start, state);
    RhexisShape shape;
    shape.opened = opening.exists;
    shape.closed = opening.closed;
    shape.run_out = opening.run_out;
    shape.length = opening.torn;
    shape.loose_area = opening.loose;
    shape.lip = opening.lip;
    shape.margin = opening.margin;
    if (!opening.exists) {
        return shape;
    }
    shape.largest_radius = largest_norm(flat(opening.edge));
    shape.run_out = opening.run_out || shape.largest_radius > zonules;
    const std::vector<Vec2> curve = flat(opening.curve);
    if (opening.closed) {
        shape.turned = 2.0 * std::numbers::pi;
        shape.flap_area = std::abs(ring_area(resampled(curve)));
        shape.rest_diameter = diameter_of(shape.flap_area);
        shape.rim = opening.rim;
        measure_rim_now(state, shape);
    } else {
        shape.turned = turned_by(curve);
        shape.flap_area = std::abs(ring_area(curve));
    }
    if (opening.tip >= 0) {
        const TearTip& tip = state.tips[static_cast<std::size_t>(opening.tip)];
        const Vec3& place = state.sheet->mesh.nodes[static_cast<std::size_t>(tip.node)];
        measure_tip(place.head<2>(), tip.direction.head<2>(), shape);
    }
    return shape;
}

void measure_rim_now(const MembraneState& state, RhexisShape& shape) {
    std::vector<Vec2> rim;
    for (const int node : shape.rim) {
        rim.emplace_back(state.position[static_cast<std::size_t>(node)].head<2>());
    }
    measure_rim(rim, shape);
}

double zonules_end(const MembraneModel& model) {
    double farthest = -1.0;
    for (const NodeSpring& spring : model.springs) {
        if (spring.slack > 0.0) {
            farthest =
                std::max(farthest, model.sheet->mesh.nodes[static_cast<std::size_t>(spring.node)].head<2>().norm());
        }
    }
    return farthest < 0.0 ? std::numeric_limits<double>::infinity() : farthest;
}

void RhexisGauge::measure(const MembraneModel& model, const MembraneState& state) {
    if (measured_ != state.sheet) {
        shape_ = rhexis_shape(*model.sheet, state, zonules_end(model));
        measured_ = state.sheet;
    } else if (shape_.closed) {
        measure_rim_now(state, shape_);
    }
}

}  // namespace rhexis
