// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/optical_path.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "mesh/places.hpp"

namespace rhexis {

namespace {

/// Node positions across the ray: a tetrahedron is met only if the origin lies in the box of its corners.
std::vector<Vec2> across(const Vec3& origin, const Vec3& direction, std::span<const Vec3> nodes) {
    const Vec3 u = direction.unitOrthogonal();
    const Vec3 w = direction.cross(u);
    std::vector<Vec2> result;
    result.reserve(nodes.size());
    for (const Vec3& node : nodes) {
        const Vec3 offset = node - origin;
        result.emplace_back(offset.dot(u), offset.dot(w));
    }
    return result;
}

bool box_holds_origin(const std::vector<Vec2>& flat, const std::array<int, 4>& tet) {
    for (int axis = 0; axis < 2; ++axis) {
        int below = 0;
        int above = 0;
        for (int node : tet) {
            below += flat[node][axis] <= 0.0;
            above += flat[node][axis] >= 0.0;
        }
        if (below == 0 || above == 0) {
            return false;
        }
    }
    return true;
}

Vec3 fine_node(const AbsorbingBody& body, int node) { return fine_point(body.fine, body.nodes, node); }

std::array<Vec3, 4> coarse_corners(const AbsorbingBody& body, int t) {
    const std::array<int, 4>& tet = body.coarse.tets[t];
    return {body.nodes[tet[0]], body.nodes[tet[1]], body.nodes[tet[2]], body.nodes[tet[3]]};
}

std::array<Vec3, 4> fine_corners(const AbsorbingBody& body, int child) {
    const std::array<int, 4>& tet = body.fine.tets[child];
    return {fine_node(body, tet[0]), fine_node(body, tet[1]), fine_node(body, tet[2]), fine_node(body, tet[3])};
}

/// Length in coarse tetrahedron t, weighted by what is left of its children.
double filled_length(const Vec3& origin, const Vec3& direction, const AbsorbingBody& body, int t, double limit) {
    if (body.fine.tets.empty()) {
        return body.density[t] * length_inside(origin, direction, coarse_corners(body, t), limit);
    }
    const std::span<const double> children = body.density.subspan(8 * static_cast<std::size_t>(t), 8);
    const bool equal = std::all_of(children.begin(), children.end(), [&](double d) { return d == children[0]; });
    if (equal) {
        return children[0] == 0.0 ? 0.0
                                  : children[0] * length_inside(origin, direction, coarse_corners(body, t), limit);
    }
    double length = 0.0;
    for (int child = 0; child < 8; ++child) {
        if (children[child] != 0.0) {
            length += children[child] * length_inside(origin, direction, fine_corners(body, 8 * t + child), limit);
        }
    }
    return length;
}

}  // namespace

double length_inside(const Vec3& origin, const Vec3& direction, const std::array<Vec3, 4>& corners,
                     double max_distance) {
    double enter = 0.0;
    double leave = max_distance;
    for (int k = 0; k < 4; ++k) {
        const Vec3& a = corners[tet_faces[k][0]];
        const Vec3 edge_one = corners[tet_faces[k][1]] - a;
        const Vec3 edge_two = corners[tet_faces[k][2]] - a;
        Vec3 normal = edge_one.cross(edge_two);
        if (normal.dot(corners[k] - a) > 0.0) {
            normal = -normal;
        }
        const double approach = normal.dot(direction);
        const double outside = normal.dot(origin - a);
        if (approach < 0.0) {
            enter = std::max(enter, -outside / approach);
        } else if (approach > 0.0) {
            leave = std::min(leave, -outside / approach);
        } else if (outside > 0.0) {
            return 0.0;
        }
    }
    return std::max(0.0, leave - enter);
}

Vec3 optical_depth_along(const Vec3& origin, const Vec3& direction, const AbsorbingBody& body, double max_distance) {
    RHEXIS_ASSERT(body.density.size() == (body.fine.tets.empty() ? body.coarse.tets.size() : body.fine.tets.size()));
    RHEXIS_ASSERT(body.extinction.size() == body.coarse.tets.size());
    const std::vector<Vec2> flat = across(origin, direction, body.nodes);
    Vec3 depth = Vec3::Zero();
    const int count = static_cast<int>(body.coarse.tets.size());
    for (int t = 0; t < count; ++t) {
        if (box_holds_origin(flat, body.coarse.tets[t])) {
            depth += body.extinction[t] * filled_length(origin, direction, body, t, max_distance);
        }
    }
    return depth;
}

}  // namespace rhexis
