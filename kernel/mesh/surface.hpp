// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of what is left of a tetrahedral mesh.
#pragma once

#include <cstdint>
#include <span>

#include "mesh/tet_mesh.hpp"

namespace rhexis {

/// Triangles oriented outward (counter-clockwise seen from outside), with the tetrahedron behind each.
struct Surface {
    std::vector<std::array<int, 3>> triangles;  ///< node indices of the tetrahedral mesh
    std::vector<int> tet;                       ///< one per triangle
    std::vector<int> vertices;                  ///< nodes of the triangles, ascending
};

/// Faces of tetrahedra with left[t] > 0 across which there is none with left > 0. neighbours as in FineMesh;
/// left: one per tetrahedron, e.g. the fractions of the fine mesh.
Surface surface_of(std::span<const std::array<int, 4>> tets, std::span<const std::array<int, 4>> neighbours,
                   std::span<const double> left);

/// The same for masks, e.g. the present coarse tetrahedra.
Surface surface_of(std::span<const std::array<int, 4>> tets, std::span<const std::array<int, 4>> neighbours,
                   std::span<const std::uint8_t> present);

/// The whole mesh's surface.
Surface surface_of(const TetMesh& mesh);

}  // namespace rhexis
