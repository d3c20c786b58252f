// SPDX-License-Identifier: GPL-3.0-or-later
// The four material points of a fine tetrahedron: those that integrate it to second order. Tissue is taken away point
// by point, and tools meet what is left of them.
#pragma once

#include <array>

#include "mesh/tet_mesh.hpp"

namespace rhexis {

/// Per point: the weights of the four nodes of the coarse tetrahedron that the fine one is a part of; they sum to 1.
using PointWeights = std::array<std::array<double, 4>, 4>;

/// Their places, from the corners of the fine tetrahedron.
std::array<Vec3, 4> material_places(const std::array<Vec3, 4>& corners);

PointWeights material_points(const TetMesh& coarse, const FineMesh& mesh, int fine);

}  // namespace rhexis
