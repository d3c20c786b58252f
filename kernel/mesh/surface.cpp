// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "mesh/adjacency.hpp"

namespace rhexis {

namespace {

void collect_vertices(Surface& surface) {
    for (const std::array<int, 3>& triangle : surface.triangles) {
        surface.vertices.insert(surface.vertices.end(), triangle.begin(), triangle.end());
    }
    std::sort(surface.vertices.begin(), surface.vertices.end());
    surface.vertices.erase(std::unique(surface.vertices.begin(), surface.vertices.end()), surface.vertices.end());
}

template <typename IsLeft>
Surface collect(std::span<const std::array<int, 4>> tets, std::span<const std::array<int, 4>> neighbours,
                const IsLeft& is_left) {
    Surface surface;
    for (std::size_t t = 0; t < tets.size(); ++t) {
        for (std::size_t k = 0; is_left(t) && k < 4; ++k) {
            const int other = neighbours[t][k];
            if (other < 0 || !is_left(static_cast<std::size_t>(other))) {
                std::array<int, 3> triangle{};
                for (std::size_t i = 0; i < 3; ++i) {
                    triangle[i] = tets[t][static_cast<std::size_t>(tet_faces[k][i])];
                }
                surface.triangles.push_back(triangle);
                surface.tet.push_back(static_cast<int>(t));
            }
        }
    }
    collect_vertices(surface);
    return surface;
}

}  // namespace

Surface surface_of(std::span<const std::array<int, 4>> tets, std::span<const std::array<int, 4>> neighbours,
                   std::span<const double> left) {
    RHEXIS_ASSERT(tets.size() == neighbours.size() && tets.size() == left.size());
    return collect(tets, neighbours, [left](std::size_t t) { return left[t] > 0.0; });
}

Surface surface_of(std::span<const std::array<int, 4>> tets, std::span<const std::array<int, 4>> neighbours,
                   std::span<const std::uint8_t> present) {
    RHEXIS_ASSERT(tets.size() == neighbours.size() && tets.size() == present.size());
    return collect(tets, neighbours, [present](std::size_t t) { return present[t] != 0; });
}

Surface surface_of(const TetMesh& mesh) {
    return collect(mesh.tets, face_neighbours(mesh.tets), [](std::size_t) { return true; });
}

}  // namespace rhexis
