// SPDX-License-Identifier: GPL-3.0-or-later
// How well shaped the tetrahedra of a mesh are.
#pragma once

#include "mesh/tet_mesh.hpp"

namespace rhexis {

/// 3 * inscribed / circumscribed radius: 1 for the regular tetrahedron, 0 for a flat one, negative if inverted.
double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Shortest of the four heights [mm] (signed like the volume). The explicit step limit is proportional to it.
double shortest_height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

struct MeshQuality {
    double min_ratio = 0.0;   ///< of radius_ratio
    double mean_ratio = 0.0;  ///< of radius_ratio
    double min_height = 0.0;  ///< [mm]
    double volume = 0.0;      ///< [mm^3]
    int worst = -1;           ///< tetrahedron of min_ratio
};

/// All zero for an empty mesh.
MeshQuality mesh_quality(const TetMesh& mesh);

}  // namespace rhexis
