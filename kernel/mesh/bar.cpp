// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "mesh/shapes.hpp"

namespace rhexis {

namespace {

using Corner = std::array<int, 3>;

/// One cell in 5 tetrahedra: four at corners and one between them. The odd cut is the even one mirrored in x.
constexpr std::array<std::array<Corner, 4>, 5> even_cut{{
    {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}}},
    {{{1, 0, 1}, {1, 0, 0}, {0, 0, 1}, {1, 1, 1}}},
    {{{0, 1, 1}, {0, 0, 1}, {0, 1, 0}, {1, 1, 1}}},
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}},
}};

void cut_cell(int i, int j, int k, int nx, int ny, TetMesh& mesh) {
    const bool odd = (i + j + k) % 2 != 0;
    for (const std::array<Corner, 4>& corners : even_cut) {
        std::array<int, 4> tet{};
        for (std::size_t v = 0; v < 4; ++v) {
            const auto [a, b, c] = corners[v];
            const int x = i + (odd ? 1 - a : a);
            tet[v] = x + (nx + 1) * (j + b + (ny + 1) * (k + c));
        }
        mesh.tets.push_back(odd ? std::array<int, 4>{tet[0], tet[2], tet[1], tet[3]} : tet);
    }
}

}  // namespace

TetMesh bar(int nx, int ny, int nz, double cell, const Vec3& origin) {
    TetMesh mesh;
    for (int k = 0; k <= nz; ++k) {
        for (int j = 0; j <= ny; ++j) {
            for (int i = 0; i <= nx; ++i) {
                mesh.nodes.push_back(origin + cell * Vec3(i, j, k));
            }
        }
    }
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                cut_cell(i, j, k, nx, ny, mesh);
            }
        }
    }
    mesh.region.assign(mesh.tets.size(), 0);
    return mesh;
}

std::vector<int> nodes_on_plane(const TetMesh& mesh, const Vec3& point, const Vec3& normal, double tolerance) {
    std::vector<int> nodes;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (std::abs((mesh.nodes[n] - point).dot(normal)) <= tolerance) {
            nodes.push_back(static_cast<int>(n));
        }
    }
    return nodes;
}

}  // namespace rhexis
