// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/adjacency.hpp"

#include <algorithm>
#include <numeric>

#include "mesh/tet_mesh.hpp"

namespace rhexis {

namespace {

struct Face {
    std::array<int, 3> nodes;  ///< ascending
    int tet;
    int local;

    bool operator<(const Face& other) const {
        return nodes != other.nodes ? nodes < other.nodes : 4 * tet + local < 4 * other.tet + other.local;
    }
};

Face face_of(const std::array<int, 4>& tet, std::size_t t, std::size_t k) {
    Face face{{}, static_cast<int>(t), static_cast<int>(k)};
    for (std::size_t i = 0; i < 3; ++i) {
        face.nodes[i] = tet[static_cast<std::size_t>(tet_faces[k][i])];
    }
    std::sort(face.nodes.begin(), face.nodes.end());
    return face;
}

/// Counted by their lowest nodes, then sorted among the few that share it.
std::vector<Face> sorted_faces(const std::vector<std::array<int, 4>>& tets) {
    std::vector<Face> unsorted;
    unsorted.reserve(4 * tets.size());
    std::vector<std::size_t> first(1, 0);
    for (std::size_t t = 0; t < tets.size(); ++t) {
        for (std::size_t k = 0; k < 4; ++k) {
            unsorted.push_back(face_of(tets[t], t, k));
            const std::size_t lowest = static_cast<std::size_t>(unsorted.back().nodes[0]);
            first.resize(std::max(first.size(), lowest + 2), 0);
            ++first[lowest + 1];
        }
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Face> faces(unsorted.size());
    std::vector<std::size_t> next = first;
    for (const Face& face : unsorted) {
        faces[next[static_cast<std::size_t>(face.nodes[0])]++] = face;
    }
    for (std::size_t node = 0; node + 1 < first.size(); ++node) {
        std::sort(faces.begin() + static_cast<std::ptrdiff_t>(first[node]),
                  faces.begin() + static_cast<std::ptrdiff_t>(first[node + 1]));
    }
    return faces;
}

}  // namespace

std::vector<std::array<int, 4>> face_neighbours(const std::vector<std::array<int, 4>>& tets) {
    std::vector<std::array<int, 4>> neighbours(tets.size(), {-1, -1, -1, -1});
    const std::vector<Face> faces = sorted_faces(tets);
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
        const Face& a = faces[i];
        const Face& b = faces[i + 1];
        if (a.nodes == b.nodes) {
            neighbours[static_cast<std::size_t>(a.tet)][static_cast<std::size_t>(a.local)] = b.tet;
            neighbours[static_cast<std::size_t>(b.tet)][static_cast<std::size_t>(b.local)] = a.tet;
            ++i;
        }
    }
    return neighbours;
}

NodeTets node_tets(const std::vector<std::array<int, 4>>& tets, int node_count) {
    NodeTets result;
    result.offset.assign(static_cast<std::size_t>(node_count) + 1, 0);
    for (const std::array<int, 4>& tet : tets) {
        for (int node : tet) {
            ++result.offset[static_cast<std::size_t>(node) + 1];
        }
    }
    for (std::size_t n = 1; n < result.offset.size(); ++n) {
        result.offset[n] += result.offset[n - 1];
    }
    result.tets.resize(4 * tets.size());
    std::vector<int> next(result.offset.begin(), result.offset.end() - 1);
    for (std::size_t t = 0; t < tets.size(); ++t) {
        for (int node : tets[t]) {
            result.tets[static_cast<std::size_t>(next[static_cast<std::size_t>(node)]++)] = static_cast<int>(t);
        }
    }
    return result;
}

}  // namespace rhexis
