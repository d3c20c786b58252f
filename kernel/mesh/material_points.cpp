// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/material_points.hpp"

namespace rhexis {

namespace {

// (5 + 3 sqrt 5) / 20 and (5 - sqrt 5) / 20
constexpr double own = 0.58541020;
constexpr double others = 0.13819660;

/// Adds what a fine node is of the nodes of its coarse tetrahedron.
void add_node(const TetMesh& coarse, const FineMesh& mesh, const std::array<int, 4>& tet, int node, double share,
              std::array<double, 4>& weights) {
    const std::size_t nodes = coarse.nodes.size();
    const std::size_t index = static_cast<std::size_t>(node);
    const std::array<int, 2> ends = index < nodes ? std::array<int, 2>{node, node} : mesh.edges[index - nodes];
    for (std::size_t k = 0; k < 4; ++k) {
        weights[k] += 0.5 * share * static_cast<double>((tet[k] == ends[0] ? 1 : 0) + (tet[k] == ends[1] ? 1 : 0));
    }
}

}  // namespace

std::array<Vec3, 4> material_places(const std::array<Vec3, 4>& corners) {
    const Vec3 sum = corners[0] + corners[1] + corners[2] + corners[3];
    std::array<Vec3, 4> places;
    for (std::size_t k = 0; k < 4; ++k) {
        places[k] = others * sum + (own - others) * corners[k];
    }
    return places;
}

PointWeights material_points(const TetMesh& coarse, const FineMesh& mesh, int fine) {
    const std::array<int, 4>& tet = coarse.tets[static_cast<std::size_t>(fine / 8)];
    PointWeights points{};
    for (std::size_t p = 0; p < 4; ++p) {
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const int node = mesh.tets[static_cast<std::size_t>(fine)][corner];
            add_node(coarse, mesh, tet, node, corner == p ? own : others, points[p]);
        }
    }
    return points;
}

}  // namespace rhexis
