// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedral meshes and their 1-to-8 refinement.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/types.hpp"

namespace rhexis {

/// A tetrahedral mesh at rest. Positive orientation: det(X1 - X0, X2 - X0, X3 - X0) > 0.
struct TetMesh {
    std::vector<Vec3> nodes;               ///< [mm]
    std::vector<std::array<int, 4>> tets;  ///< node indices
    std::vector<int> region;               ///< one per tetrahedron: index into the body's materials; all 0 if uniform
};

/// Each coarse tetrahedron split into 8. Fine nodes are the coarse nodes, in their order, followed by one midpoint per
/// coarse edge; children of coarse tetrahedron t are 8 t .. 8 t + 7, corner children first, each of volume V_t / 8 at
/// rest. Fine positions are never stored as state: they follow from the coarse ones.
struct FineMesh {
    std::vector<std::array<int, 2>> edges;  ///< coarse node pairs; fine node (coarse node count + e) is the middle of e
    std::vector<std::array<int, 4>> tets;   ///< fine node indices, positively oriented
    /// Across the face opposite fine node k of fine tetrahedron t: its neighbour, or -1 outside the body.
    std::vector<std::array<int, 4>> neighbours;
};

/// Node indices of the face opposite local node k, ordered so that the normal points out of a positively oriented tet.
inline constexpr std::array<std::array<int, 3>, 4> tet_faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Signed volume [mm^3].
double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sum of signed volumes [mm^3].
double mesh_volume(const TetMesh& mesh);

/// Splits every tetrahedron into 8 through its edge midpoints (shortest inner diagonal).
FineMesh subdivide(const TetMesh& mesh);

/// Positions of all fine nodes for given coarse positions. fine is resized to coarse.size() + mesh.edges.size().
void fine_positions(const FineMesh& mesh, const std::vector<Vec3>& coarse, std::vector<Vec3>& fine);

}  // namespace rhexis
