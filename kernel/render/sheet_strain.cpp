// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sheet_strain.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

namespace {

constexpr double full_pull = 0.06;     ///< strain at which wrinkles are as deep as they get
constexpr double full_slack = 0.04;    ///< and shortening across it, beyond what the pull itself takes
constexpr double poisson_ratio = 0.4;  ///< of that shortening: what lies below it makes no wrinkles

/// Edges of a triangle in its plane, as columns; `across` receives the plane's second axis.
Eigen::Matrix2d flat_edges(const Vec3& u, const Vec3& v, Vec3& along, Vec3& across) {
    along = u.normalized();
    across = (v - along.dot(v) * along).normalized();
    Eigen::Matrix2d edges;
    edges << u.norm(), along.dot(v), 0.0, across.dot(v);
    return edges;
}

Vec3 wrinkles_of(const std::array<Vec3, 3>& rest, const std::array<Vec3, 3>& now) {
    Vec3 along;
    Vec3 across;
    const Eigen::Matrix2d before = flat_edges(rest[1] - rest[0], rest[2] - rest[0], along, across);
    const Eigen::Matrix2d after = flat_edges(now[1] - now[0], now[2] - now[0], along, across);
    if (!after.allFinite() || std::abs(before.determinant()) < 1e-12) {
        return Vec3::Zero();
    }
    const Eigen::Matrix2d gradient = after * before.inverse();
    // Principal stretches: eigenvalues of F F^T, by hand for two rows.
    const Eigen::Matrix2d finger = gradient * gradient.transpose();
    const double middle = 0.5 * finger.trace();
    const double half = std::hypot(0.5 * (finger(0, 0) - finger(1, 1)), finger(0, 1));
    const double pull = std::sqrt(std::max(0.0, middle + half)) - 1.0;
    const double slack = 1.0 - std::sqrt(std::max(0.0, middle - half)) - poisson_ratio * std::max(0.0, pull);
    const double depth = std::clamp(pull / full_pull, 0.0, 1.0) * std::clamp(slack / full_slack, 0.0, 1.0);
    if (depth <= 0.0) {
        return Vec3::Zero();
    }
    const double angle = 0.5 * std::atan2(2.0 * finger(0, 1), finger(0, 0) - finger(1, 1));
    const Vec3 direction = std::cos(angle) * along + std::sin(angle) * across;
    const double turned = 2.0 * std::atan2(direction.y(), direction.x());
    return depth * Vec3(std::cos(turned), std::sin(turned), 0.0);
}

}  // namespace

std::vector<Vec3> wrinkles(const MembraneState& state) {
    std::vector<Vec3> sum(state.position.size(), Vec3::Zero());
    std::vector<double> count(state.position.size(), 0.0);
    const TriMesh& mesh = state.sheet->mesh;
    for (const std::array<int, 3>& t : mesh.triangles) {
        const Vec3 own = wrinkles_of({mesh.nodes[t[0]], mesh.nodes[t[1]], mesh.nodes[t[2]]},
                                     {state.position[t[0]], state.position[t[1]], state.position[t[2]]});
        for (int node : t) {
            sum[node] += own;
            count[node] += 1.0;
        }
    }
    for (std::size_t n = 0; n < sum.size(); ++n) {
        sum[n] /= std::max(1.0, count[n]);
    }
    return sum;
}

}  // namespace rhexis
