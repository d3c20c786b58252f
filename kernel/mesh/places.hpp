// SPDX-License-Identifier: GPL-3.0-or-later
// Where things of a mesh are, for given places of its coarse nodes.
#pragma once

#include <span>

#include "mesh/tet_mesh.hpp"

namespace rhexis {

/// A fine node: a coarse one, or the middle of an edge.
inline Vec3 fine_point(const FineMesh& mesh, std::span<const Vec3> coarse, int node) {
    const std::size_t first = coarse.size();
    const std::size_t index = static_cast<std::size_t>(node);
    if (index < first) {
        return coarse[index];
    }
    const std::array<int, 2>& edge = mesh.edges[index - first];
    return 0.5 * (coarse[static_cast<std::size_t>(edge[0])] + coarse[static_cast<std::size_t>(edge[1])]);
}

/// Middle of a coarse tetrahedron.
inline Vec3 centroid(std::span<const Vec3> nodes, const std::array<int, 4>& tet) {
    return 0.25 * (nodes[static_cast<std::size_t>(tet[0])] + nodes[static_cast<std::size_t>(tet[1])] +
                   nodes[static_cast<std::size_t>(tet[2])] + nodes[static_cast<std::size_t>(tet[3])]);
}

/// Middle of a fine tetrahedron.
inline Vec3 fine_middle(const FineMesh& mesh, std::span<const Vec3> coarse, int tet) {
    Vec3 sum = Vec3::Zero();
    for (const int node : mesh.tets[static_cast<std::size_t>(tet)]) {
        sum += 0.25 * fine_point(mesh, coarse, node);
    }
    return sum;
}

}  // namespace rhexis
