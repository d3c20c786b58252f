// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/bag_place.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/index.hpp"
#include "math/turn.hpp"

namespace rhexis {
namespace {

constexpr int sectors = 32;
constexpr double rim_width = 0.5;  ///< of the bag beside the rim [mm]

Vec3 mean_of(const std::vector<Vec3>& x, const std::vector<int>& nodes) {
    Vec3 sum = Vec3::Zero();
    for (const int n : nodes) {
        sum += x[at(n)];
    }
    return sum / static_cast<double>(nodes.size());
}

double mean_radius(const TriMesh& mesh, const std::vector<int>& loop) {
    double sum = 0.0;
    for (const int n : loop) {
        sum += mesh.nodes[at(n)].head<2>().norm();
    }
    return sum / static_cast<double>(loop.size());
}

/// Half the solid angle of a triangle, seen from a place [VanOosterom1983].
double half_solid_angle(const Vec3& place, const Vec3& corner_a, const Vec3& corner_b, const Vec3& corner_c) {
    const Vec3 a = corner_a - place;
    const Vec3 b = corner_b - place;
    const Vec3 c = corner_c - place;
    const double na = a.norm();
    const double nb = b.norm();
    const double nc = c.norm();
    return std::atan2(a.dot(b.cross(c)), na * nb * nc + a.dot(b) * nc + b.dot(c) * na + c.dot(a) * nb);
}

}  // namespace

BagGauge::BagGauge(const MembraneModel& model) : seen_(model.sheet) {
    find_equator(model.sheet->mesh);
    find_rim(*model.sheet);
}

void BagGauge::find_equator(const TriMesh& mesh) {
    std::array<int, sectors> farthest{};
    farthest.fill(-1);
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
        const Vec3& place = mesh.nodes[at(n)];
        int& best = farthest[at(std::min(sectors - 1, static_cast<int>(sectors * share_of_turn(place))))];
        if (best < 0 || place.head<2>().squaredNorm() > mesh.nodes[at(best)].head<2>().squaredNorm()) {
            best = n;
        }
    }
    std::copy_if(farthest.begin(), farthest.end(), std::back_inserter(equator_), [](int node) { return node >= 0; });
    rest_middle_ = mean_of(mesh.nodes, equator_);
    equator_z_ = rest_middle_.z();
    Mat2 moments = Mat2::Zero();
    for (const int n : equator_) {
        const Vec2 arm = (mesh.nodes[at(n)] - rest_middle_).head<2>();
        moments += arm * arm.transpose();
    }
    const Mat2 inverse = moments.inverse();
    for (const int n : equator_) {
        weight_.emplace_back(inverse * (mesh.nodes[at(n)] - rest_middle_).head<2>());
    }
    rest_frame_ = frame(mesh.nodes, rest_middle_);
}

/// Columns: where x, y and z of the equator's plane at rest have gone.
Mat3 BagGauge::frame(const std::vector<Vec3>& x, const Vec3& middle) const {
    Vec3 across = Vec3::Zero();
    Vec3 along = Vec3::Zero();
    for (std::size_t i = 0; i < equator_.size(); ++i) {
        const Vec3 arm = x[at(equator_[i])] - middle;
        across += weight_[i].x() * arm;
        along += weight_[i].y() * arm;
    }
    Mat3 frame;
    frame.col(2) = across.cross(along).normalized();
    frame.col(0) = across.normalized();
    frame.col(1) = frame.col(2).cross(frame.col(0));
    return frame;
}

void BagGauge::find_rim(const MembraneSheet& sheet) {
    const std::vector<std::vector<int>> loops = boundary_loops(sheet.mesh, sheet.neighbours);
    const auto narrowest = std::min_element(loops.begin(), loops.end(), [&](const auto& a, const auto& b) {
        return mean_radius(sheet.mesh, a) < mean_radius(sheet.mesh, b);
    });
    if (narrowest == loops.end()) {
        return;
    }
    rim_ = *narrowest;
    const std::vector<Vec3>& x = sheet.mesh.nodes;
    double whole = 0.0;
    for (std::size_t i = 0; i < rim_.size(); ++i) {
        RimEdge edge{{rim_[i], rim_[(i + 1) % rim_.size()]}, 0.0, {}};
        edge.length = (x[at(edge.nodes[1])] - x[at(edge.nodes[0])]).norm();
        whole += edge.length;
        edges_.push_back(edge);
    }
    double from = 0.0;
    for (RimEdge& edge : edges_) {
        for (std::size_t k = 0; k < edge.share.size(); ++k) {
            const double low = static_cast<double>(k) / 8.0 * whole;
            const double overlap = std::min(from + edge.length, low + whole / 8.0) - std::max(from, low);
            edge.share[k] = std::max(0.0, overlap) / edge.length;
        }
        from += edge.length;
    }
}

/// After a tear: what of the rim is still there.
void BagGauge::follow(const MembraneSheet& sheet) {
    std::map<std::array<int, 2>, std::array<int, 2>> found;  // by nodes of the first sheet, in their order
    for (std::size_t t = 0; t < sheet.mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (sheet.neighbours.across[t][k] < 0) {
                const int a = sheet.mesh.triangles[t][(k + 1) % 3];
                const int b = sheet.mesh.triangles[t][(k + 2) % 3];
                const int from = sheet.origin[at(a)];
                const int to = sheet.origin[at(b)];
                found[{std::min(from, to), std::max(from, to)}] = from < to ? std::array{a, b} : std::array{b, a};
            }
        }
    }
    split_ = false;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        const int from = rim_[i];
        const int to = rim_[(i + 1) % rim_.size()];
        const auto own = found.find({std::min(from, to), std::max(from, to)});
        edges_[i].nodes = own == found.end() ? std::array{-1, -1} : own->second;
        split_ = split_ || own == found.end() || own->second[0] != std::min(from, to) ||
                 own->second[1] != std::max(from, to);
    }
}

double BagGauge::stretch(const std::vector<Vec3>& x) const {
    std::array<double, 8> rest{};
    std::array<double, 8> now{};
    for (const RimEdge& edge : edges_) {
        if (edge.nodes[0] < 0) {
            continue;
        }
        const double length = (x[at(edge.nodes[1])] - x[at(edge.nodes[0])]).norm();
        for (std::size_t k = 0; k < 8; ++k) {
            rest[k] += edge.share[k] * edge.length;
            now[k] += edge.share[k] * length;
        }
    }
    double most = 0.0;
    for (std::size_t k = 0; k < 8; ++k) {
        most = std::max(most, rest[k] > 0.0 ? now[k] / rest[k] : 0.0);
    }
    return most;
}

BagPlace BagGauge::measure(const MembraneState& state) {
    if (state.sheet != seen_ && !rim_.empty()) {
        follow(*state.sheet);
        seen_ = state.sheet;
    }
    const std::vector<Vec3>& x = state.position;
    BagPlace place;
    const Vec3 middle = mean_of(x, equator_);
    const Mat3 turn = frame(x, middle) * rest_frame_.transpose();
    place.axis = turn.col(2);
    place.centre = middle - turn * Vec3(rest_middle_.x(), rest_middle_.y(), 0.0);
    for (const int n : equator_) {
        const Vec3 arm = x[at(n)] - place.centre;
        const double distance = (arm - arm.dot(place.axis) * place.axis).norm();
        place.radius += distance / static_cast<double>(equator_.size());
        place.widest = std::max(place.widest, distance);
    }
    if (rim_.empty()) {
        return place;
    }
    place.rim_centre = mean_of(x, rim_);
    for (const int n : rim_) {
        place.rim_radius += (x[at(n)] - place.rim_centre).norm() / static_cast<double>(rim_.size());
    }
    place.rim_stretch = stretch(x);
    place.rim_split = split_;
    return place;
}

bool BagGauge::holds(const MembraneState& state, const Vec3& place) const {
    const std::vector<Vec3>& x = state.position;
    double sum = 0.0;
    for (const std::array<int, 3>& t : state.sheet->mesh.triangles) {
        sum += half_solid_angle(place, x[at(t[0])], x[at(t[1])], x[at(t[2])]);
    }
    const Vec3 middle = rim_.empty() ? place : mean_of(x, rim_);
    for (std::size_t i = 0; i < rim_.size(); ++i) {  // the loop has the sheet on its left
        sum += half_solid_angle(place, middle, x[at(rim_[(i + 1) % rim_.size()])], x[at(rim_[i])]);
    }
    return std::abs(sum) > std::numbers::pi;  // within: 2 pi, outside: 0
}

bool BagGauge::is_posterior(const MembraneSheet& sheet, int node) const {
    return sheet.mesh.nodes[at(node)].z() < equator_z_;
}

bool BagGauge::is_at_rim(const MembraneSheet& sheet, int node) const {
    const Vec3& place = sheet.mesh.nodes[at(node)];
    return std::any_of(rim_.begin(), rim_.end(),
                       [&](int n) { return (sheet.mesh.nodes[at(n)] - place).squaredNorm() < rim_width * rim_width; });
}

}  // namespace rhexis
