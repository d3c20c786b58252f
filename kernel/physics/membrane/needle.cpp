// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane/needle.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace rhexis {
namespace {

constexpr double through = 1e-3;  ///< of a triangle, as weights of its corners: a needle there is through it

constexpr double dent_at_tear = 0.15;  ///< of a needle beside a tear: deeper, it has slipped into it [mm]
constexpr double farthest_lip = 1.0;   ///< from a needle that stands in a tear [mm]

/// The point of a segment that is nearest to another: share of the way from a to b.
double share_nearest(const Vec3& a, const Vec3& b, const Vec3& place) {
    const Vec3 along = b - a;
    const double square = along.squaredNorm();
    return square > 0.0 ? std::clamp(along.dot(place - a) / square, 0.0, 1.0) : 0.0;
}

/// Nearest points of two segments, as shares of both: in turn from one to the other, which is enough for a needle that
/// stands across the sheet.
std::pair<double, double> nearest_shares(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q) {
    double t = 0.5;
    double s = 0.5;
    for (int i = 0; i < 6; ++i) {
        s = share_nearest(a, b, p + t * (q - p));
        t = share_nearest(p, q, a + s * (b - a));
    }
    return {s, t};
}

}  // namespace

std::optional<SheetPlace> where_through(const MembraneState& state, const Vec3& a, const Vec3& b) {
    std::optional<SheetPlace> found;
    double nearest = 1.0;
    for (int t = 0; t < static_cast<int>(state.sheet->mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = state.sheet->mesh.triangles[at(t)];
        const Vec3& x = state.position[at(n[0])];
        if ((x - a).squaredNorm() > 4.0) {
            continue;
        }
        // a + s (b - a) = x + u e1 + v e2
        Mat3 sides;
        sides << state.position[at(n[1])] - x, state.position[at(n[2])] - x, a - b;
        const double volume = sides.determinant();
        if (!(std::abs(volume) > 1e-9)) {
            continue;
        }
        const Vec3 uvs = sides.inverse() * (a - x);
        const double least = std::min({uvs[0], uvs[1], 1.0 - uvs[0] - uvs[1]});
        if (least > through && uvs[2] >= 0.0 && uvs[2] < nearest) {
            nearest = uvs[2];
            const std::vector<Vec3>& rest = state.sheet->mesh.nodes;
            found = SheetPlace{t, a + uvs[2] * (b - a),
                               rest[at(n[0])] + uvs[0] * (rest[at(n[1])] - rest[at(n[0])]) +
                                   uvs[1] * (rest[at(n[2])] - rest[at(n[0])])};
        }
    }
    return found;
}

std::optional<NeedleLip> lip_of(const ToolModel& needle, const ToolState& tool, const MembraneState& state) {
    if (needle.kind != ToolKind::cystotome || state.torn_area == 0.0) {
        return std::nullopt;
    }
    const MembraneSheet& sheet = *state.sheet;
    const Vec3& a = tool.pose.position;
    const Vec3 b = tool.pose.to_world(needle.parts[0].b);
    const std::optional<SheetPlace> through = where_through(state, a, b);
    const bool drawn_back = tool.velocity.dot(b - a) > 0.0;  // through the hole that it came by
    if (through && !drawn_back && (through->now - a).norm() < dent_at_tear) {
        return std::nullopt;
    }
    std::optional<NeedleLip> found;
    double least = farthest_lip;
    for (int t = 0; t < static_cast<int>(sheet.mesh.triangles.size()); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (sheet.neighbours.across[at(t)][k] >= 0) {
                continue;
            }
            const std::array<int, 3>& n = sheet.mesh.triangles[at(t)];
            const std::array<int, 2> ends{n[(k + 1) % 3], n[(k + 2) % 3]};
            const Vec3& p = state.position[at(ends[0])];
            const Vec3& q = state.position[at(ends[1])];
            const auto [s, share] = nearest_shares(a, b, p, q);
            const Vec3 on_edge = p + share * (q - p);
            const Vec3 way = (through ? through->now : Vec3(a + s * (b - a))) - on_edge;
            const Vec3 along = (q - p).normalized();
            const Vec3 third = state.position[at(n[k])] - on_edge;
            const Vec3 inward = third - third.dot(along) * along;  // into the triangle, in its plane
            if (way.norm() < least && (way.dot(inward) > 0.0) == through.has_value()) {
                least = way.norm();
                found = NeedleLip{ends, through.has_value(), through ? through->rest : Vec3(Vec3::Zero())};
            }
        }
    }
    return found;
}

}  // namespace rhexis
