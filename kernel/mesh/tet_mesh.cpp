// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tet_mesh.hpp"

#include <algorithm>
#include <utility>

#include "mesh/adjacency.hpp"

namespace rhexis {

namespace {

/// Local node pairs of a tetrahedron's edges; edge 5 - e is opposite edge e.
constexpr std::array<std::array<int, 2>, 6> tet_edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Per local node, the three local edges that meet there, in the order of the other nodes.
constexpr std::array<std::array<int, 3>, 4> edges_at_node{{{0, 1, 2}, {0, 3, 4}, {1, 3, 5}, {2, 4, 5}}};

/// Per inner diagonal (edge e to edge 5 - e, e = 0, 1, 2): the other four edge midpoints, going round it.
constexpr std::array<std::array<int, 4>, 3> diagonal_rings{{{1, 3, 4, 2}, {0, 3, 5, 2}, {0, 4, 5, 1}}};

using EdgeKey = std::array<int, 2>;

EdgeKey edge_key(const std::array<int, 4>& tet, int edge) {
    const auto [i, j] = tet_edges[static_cast<std::size_t>(edge)];
    const int a = tet[static_cast<std::size_t>(i)];
    const int b = tet[static_cast<std::size_t>(j)];
    return a < b ? EdgeKey{a, b} : EdgeKey{b, a};
}

std::vector<EdgeKey> unique_edges(const TetMesh& mesh) {
    std::vector<EdgeKey> edges;
    edges.reserve(6 * mesh.tets.size());
    for (const std::array<int, 4>& tet : mesh.tets) {
        for (int edge = 0; edge < 6; ++edge) {
            edges.push_back(edge_key(tet, edge));
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

double det(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) { return (b - a).cross(c - a).dot(d - a); }

/// 0, 1 or 2: which pair of opposite edges has the closest midpoints.
int shortest_diagonal(const std::array<Vec3, 6>& middles) {
    int best = 0;
    double best_length = (middles[0] - middles[5]).squaredNorm();
    for (int e = 1; e < 3; ++e) {
        const std::size_t edge = static_cast<std::size_t>(e);
        const double length = (middles[edge] - middles[5 - edge]).squaredNorm();
        // A tie, up to rounding, goes to the first, so that equal cells are cut alike.
        if (length < best_length * (1.0 - 1e-12)) {
            best = e;
            best_length = length;
        }
    }
    return best;
}

/// Splits one tetrahedron; `middle` are the fine node indices of its six edge midpoints.
void split(const TetMesh& mesh, const std::array<int, 4>& tet, const std::array<int, 6>& middle,
           std::vector<std::array<int, 4>>& children) {
    for (std::size_t k = 0; k < 4; ++k) {
        // Seen from node k the other nodes keep their order, so the child is oriented like the parent.
        std::array<int, 4> child{};
        child[k] = tet[k];
        for (std::size_t other = 0, slot = 0; other < 4; ++other) {
            if (other != k) {
                child[other] = middle[static_cast<std::size_t>(edges_at_node[k][slot++])];
            }
        }
        children.push_back(child);
    }
    std::array<Vec3, 6> at;
    for (std::size_t e = 0; e < 6; ++e) {
        const auto [i, j] = tet_edges[e];
        at[e] = 0.5 * (mesh.nodes[static_cast<std::size_t>(tet[static_cast<std::size_t>(i)])] +
                       mesh.nodes[static_cast<std::size_t>(tet[static_cast<std::size_t>(j)])]);
    }
    const std::size_t p = static_cast<std::size_t>(shortest_diagonal(at));
    const std::size_t q = 5 - p;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t r = static_cast<std::size_t>(diagonal_rings[p][i]);
        const std::size_t s = static_cast<std::size_t>(diagonal_rings[p][(i + 1) % 4]);
        const bool positive = det(at[p], at[q], at[r], at[s]) > 0.0;
        children.push_back(positive ? std::array<int, 4>{middle[p], middle[q], middle[r], middle[s]}
                                    : std::array<int, 4>{middle[p], middle[q], middle[s], middle[r]});
    }
}

}  // namespace

double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) { return det(a, b, c, d) / 6.0; }

double mesh_volume(const TetMesh& mesh) {
    double sum = 0.0;
    for (const std::array<int, 4>& tet : mesh.tets) {
        sum += tet_volume(mesh.nodes[static_cast<std::size_t>(tet[0])], mesh.nodes[static_cast<std::size_t>(tet[1])],
                          mesh.nodes[static_cast<std::size_t>(tet[2])], mesh.nodes[static_cast<std::size_t>(tet[3])]);
    }
    return sum;
}

FineMesh subdivide(const TetMesh& mesh) {
    FineMesh fine;
    fine.edges = unique_edges(mesh);
    fine.tets.reserve(8 * mesh.tets.size());
    const int coarse_nodes = static_cast<int>(mesh.nodes.size());
    for (const std::array<int, 4>& tet : mesh.tets) {
        std::array<int, 6> middle{};
        for (int edge = 0; edge < 6; ++edge) {
            const std::vector<EdgeKey>::const_iterator found =
                std::lower_bound(fine.edges.cbegin(), fine.edges.cend(), edge_key(tet, edge));
            middle[static_cast<std::size_t>(edge)] = coarse_nodes + static_cast<int>(found - fine.edges.cbegin());
        }
        split(mesh, tet, middle, fine.tets);
    }
    fine.neighbours = face_neighbours(fine.tets);
    return fine;
}

void fine_positions(const FineMesh& mesh, const std::vector<Vec3>& coarse, std::vector<Vec3>& fine) {
    fine.resize(coarse.size() + mesh.edges.size());
    std::copy(coarse.begin(), coarse.end(), fine.begin());
    std::size_t next = coarse.size();
    for (const std::array<int, 2>& edge : mesh.edges) {
        fine[next++] = 0.5 * (coarse[static_cast<std::size_t>(edge[0])] + coarse[static_cast<std::size_t>(edge[1])]);
    }
}

}  // namespace rhexis
