// SPDX-License-Identifier: GPL-3.0-or-later
// Which tetrahedra share a face or a node.
#pragma once

#include <array>
#include <vector>

namespace rhexis {

/// Across the face opposite local node k of tetrahedron t: the tetrahedron there, or -1. A face used by more than two
/// tetrahedra (a broken mesh, which validate_mesh reports) pairs up the first two.
std::vector<std::array<int, 4>> face_neighbours(const std::vector<std::array<int, 4>>& tets);

/// Tetrahedra around each node, ascending: those of node n are tets[offset[n]] .. tets[offset[n + 1] - 1].
struct NodeTets {
    std::vector<int> offset;  ///< node count + 1
    std::vector<int> tets;
};
NodeTets node_tets(const std::vector<std::array<int, 4>>& tets, int node_count);

}  // namespace rhexis
