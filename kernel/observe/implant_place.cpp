// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/implant_place.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/index.hpp"
#include "mesh/nearest_place.hpp"

namespace rhexis {
namespace {

constexpr double root_length = 1.0;  ///< of a haptic next to the optic, which does not count as its arm [mm]
constexpr double across = 0.6;       ///< of an arm: nodes so near to each other stand for its middle line [mm]
constexpr double touching = 0.05;    ///< gap between surfaces that touch [mm]

/// Its length is the area.
Vec3 area_vector(const std::vector<Vec3>& x, const std::array<int, 3>& t) {
    return 0.5 * (x[at(t[1])] - x[at(t[0])]).cross(x[at(t[2])] - x[at(t[0])]);
}

Vec3 middle(const std::vector<Vec3>& x, const std::array<int, 3>& t) {
    return (x[at(t[0])] + x[at(t[1])] + x[at(t[2])]) / 3.0;
}

std::array<Vec3, 3> corners(const std::vector<Vec3>& x, const std::array<int, 3>& t) {
    return {x[at(t[0])], x[at(t[1])], x[at(t[2])]};
}

/// Of the nodes of an arm, by their places at rest: that which is farthest from the line from one place to another.
int farthest_from_line(const std::vector<int>& arm, const std::vector<Vec3>& rest, const Vec3& from, const Vec3& to) {
    const Vec3 along = (to - from).normalized();
    const auto away = [&](int node) { return (rest[at(node)] - from).cross(along).squaredNorm(); };
    return *std::max_element(arm.begin(), arm.end(), [&](int a, int b) { return away(a) < away(b); });
}

/// Likewise: that which is nearest to a place.
int nearest_to(const std::vector<int>& arm, const std::vector<Vec3>& rest, const Vec3& place) {
    const auto away = [&](int node) { return (rest[at(node)] - place).squaredNorm(); };
    return *std::min_element(arm.begin(), arm.end(), [&](int a, int b) { return away(a) < away(b); });
}

std::vector<int> all_near(const std::vector<int>& arm, const std::vector<Vec3>& rest, const Vec3& place) {
    std::vector<int> near;
    std::copy_if(arm.begin(), arm.end(), std::back_inserter(near),
                 [&](int node) { return (rest[at(node)] - place).norm() < across; });
    return near;
}

Vec3 mean_of(const std::vector<int>& nodes, const std::vector<Vec3>& places) {
    Vec3 sum = Vec3::Zero();
    for (const int node : nodes) {
        sum += places[at(node)];
    }
    return sum / static_cast<double>(nodes.size());
}

double gap_to(const std::array<Vec3, 3>& triangle, const Vec3& place) {
    return (place_in(triangle, nearest_to_point(triangle, place)) - place).norm();
}

}  // namespace

ImplantGauge::ImplantGauge(const ShellModel& model, const ImplantParts& parts)
    : tip_(parts.tip), half_thickness_(model.mesh.nodes.size(), 0.0) {
    const std::vector<Vec3>& rest = model.mesh.nodes;
    for (std::size_t t = 0; t < parts.part.size(); ++t) {
        const std::array<int, 3>& nodes = model.mesh.triangles[t];
        for (const int n : nodes) {
            half_thickness_[at(n)] = std::max(half_thickness_[at(n)], 0.5 * model.thickness[t]);
        }
        if (parts.part[t] == ImplantPart::optic) {
            optic_.push_back(nodes);
            area_ += area_vector(rest, nodes).norm();
            for (const int n : nodes) {
                radius_ = std::max(radius_, rest[at(n)].norm());
            }
        }
    }
    for (std::size_t t = 0; t < parts.part.size(); ++t) {
        for (const int n : model.mesh.triangles[t]) {
            if (parts.part[t] != ImplantPart::optic && rest[at(n)].norm() > radius_ + root_length) {
                arm_[parts.part[t] == ImplantPart::upper_haptic ? 0 : 1].push_back(n);
            }
        }
    }
    for (std::vector<int>& nodes : arm_) {
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3& tip = rest[at(tip_[i])];
        const Vec3& root = rest[at(nearest_to(arm_[i], rest, Vec3::Zero()))];
        const Vec3& elbow = rest[at(farthest_from_line(arm_[i], rest, root, tip))];
        const Vec3 between = 0.5 * (elbow + tip);
        elbow_[i] = all_near(arm_[i], rest, elbow);
        middle_[i] =
            all_near(arm_[i], rest, rest[at(nearest_to(arm_[i], rest, tip.norm() / between.norm() * between))]);
    }
}

bool ImplantGauge::touches_optic(const ShellState& state, int arm_node, const Vec3& centre) const {
    const Vec3& place = state.position[at(arm_node)];
    if ((place - centre).norm() > radius_ + 2.0 * half_thickness_[at(arm_node)] + touching) {
        return false;
    }
    return std::any_of(optic_.begin(), optic_.end(), [&](const std::array<int, 3>& t) {
        const double reach = half_thickness_[at(arm_node)] + half_thickness_[at(t[0])] + touching;
        const Vec3& near = state.position[at(t[0])];
        return (place - near).squaredNorm() < (reach + 1.0) * (reach + 1.0) &&
               gap_to(corners(state.position, t), place) < reach;
    });
}

ImplantPlace ImplantGauge::measure(const ShellState& state) const {
    ImplantPlace place;
    Vec3 sum = Vec3::Zero();
    double area = 0.0;
    for (const std::array<int, 3>& t : optic_) {
        const Vec3 own = area_vector(state.position, t);
        sum += own;
        area += own.norm();
        place.centre += own.norm() * middle(state.position, t);
    }
    place.centre /= area;
    place.radius = radius_;
    place.half_thickness = half_thickness_;
    place.unfolded = std::min(1.0, sum.norm() / area_);
    place.normal = sum.norm() > 0.0 ? Vec3(sum.normalized()) : Vec3(Vec3::UnitZ());
    for (std::size_t i = 0; i < 2; ++i) {
        place.tip[i] = state.position[at(tip_[i])];
        place.elbow[i] = mean_of(elbow_[i], state.position);
        place.middle[i] = mean_of(middle_[i], state.position);
        place.on_optic[i] = std::any_of(arm_[i].begin(), arm_[i].end(),
                                        [&](int node) { return touches_optic(state, node, place.centre); });
    }
    return place;
}

bool in_bore(const Cartridge& cartridge, const ToolState& injector, const Vec3& place) {
    return within_bore(cartridge.bore, cartridge.bore.pose.to_body(injector.pose.to_body(place)));
}

bool is_in_cartridge(const ShellState& implant, const Cartridge& cartridge, const ToolState& injector) {
    return implant.loaded ||
           (injector.present && std::any_of(implant.position.begin(), implant.position.end(),
                                            [&](const Vec3& place) { return in_bore(cartridge, injector, place); }));
}

}  // namespace rhexis
