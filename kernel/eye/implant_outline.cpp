// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/implant_outline.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {
namespace {

// of the triangles' edges at scale 1 [mm]
constexpr double edge_at_root = 0.21;
constexpr double edge_in_optic = 0.40;
constexpr double edge_in_arm = 0.26;
constexpr double growth = 0.22;  // per distance from a root

constexpr double elbow = 1.14;           // angle about the optic's axis where the arm begins to go round [rad]
constexpr double tip_angle = 2.16;       // and where it ends
constexpr double widening = 2.2;         // of the root, over the arm
constexpr double widening_length = 1.3;  // [mm]
constexpr double rounding = 0.55;        // of the tip: share of the width in the last section

double root_width(const ImplantShape& shape) { return widening * shape.haptic_width; }

/// The middle line, finely: a cubic from the rim to the elbow, then a circle.
std::vector<Vec2> middle_line(const ImplantShape& shape) {
    const double optic = 0.5 * shape.optic_diameter;
    const double arm = 0.5 * (shape.overall_diameter - shape.haptic_width);
    const Vec2 start = optic * direction_at(haptic_root);
    const Vec2 end = arm * direction_at(elbow);
    const Vec2 round(-direction_at(elbow).y(), direction_at(elbow).x());
    const Vec2 first = start + 0.55 * (arm - optic) * direction_at(haptic_root);
    const Vec2 second = end - 0.50 * (arm - optic) * round;
    std::vector<Vec2> line;
    constexpr int parts = 200;
    for (int i = 0; i <= parts; ++i) {
        const double t = static_cast<double>(i) / parts;
        const double s = 1.0 - t;
        line.push_back(s * s * s * start + 3.0 * s * s * t * first + 3.0 * s * t * t * second + t * t * t * end);
    }
    for (int i = 1; i <= parts; ++i) {
        line.push_back(arm * direction_at(elbow + (tip_angle - elbow) * i / parts));
    }
    return line;
}

double width_at(const ImplantShape& shape, double way) {
    const double t = std::clamp(1.0 - way / widening_length, 0.0, 1.0);
    return shape.haptic_width + (root_width(shape) - shape.haptic_width) * t * t;
}

}  // namespace

double half_root(const ImplantShape& shape) { return root_width(shape) / shape.optic_diameter; }

double wanted_edge(const ImplantShape& shape, const Vec2& place, double scale) {
    const Vec2 root = 0.5 * shape.optic_diameter * direction_at(haptic_root);
    const double distance = std::min((place - root).norm(), (place + root).norm()) - 0.5 * root_width(shape);
    return std::min(scale * edge_in_optic, scale * edge_at_root + growth * std::max(distance, 0.0));
}

std::vector<HapticSection> haptic_sections(const ImplantShape& shape, double scale) {
    const std::vector<Vec2> line = middle_line(shape);
    // stations of the steps: each as long as wanted where it begins, all stretched to end at the tip
    std::vector<double> way{0.0};
    for (std::size_t i = 1; i < line.size(); ++i) {
        way.push_back(way.back() + (line[i] - line[i - 1]).norm());
    }
    std::vector<double> station{0.0};
    const auto edge_at = [scale](double along) {
        return std::min(scale * edge_in_arm, scale * edge_at_root + 0.1 * growth * along);
    };
    while (station.back() < way.back()) {
        station.push_back(station.back() + 0.92 * edge_at(station.back()));
    }
    const double stretch = way.back() / station.back();
    std::vector<HapticSection> sections;
    std::size_t i = 1;
    for (std::size_t k = 1; k < station.size(); ++k) {
        const double there = std::min(stretch * station[k], way.back());
        while (i + 1 < way.size() && way[i] < there) {
            ++i;
        }
        const double t = (there - way[i - 1]) / (way[i] - way[i - 1]);
        sections.push_back({line[i - 1] + t * (line[i] - line[i - 1]), (line[i] - line[i - 1]).normalized(),
                            width_at(shape, there), edge_at(there)});
    }
    sections.back().width *= rounding;
    return sections;
}

}  // namespace rhexis
