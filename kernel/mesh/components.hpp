// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace rhexis {

/// Sets of numbers 0 .. count - 1 that grow together; each is named by its lowest member.
class UnionFind {
public:
    explicit UnionFind(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    int find(int i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(int i, int j) {
        const int a = find(i);
        const int b = find(j);
        parent_[a > b ? a : b] = a < b ? a : b;
    }

private:
    std::vector<int> parent_;
};

/// Per tetrahedron the lowest one that it hangs together with by shared nodes; -1 where `present` is 0.
std::vector<int> pieces_by_nodes(const std::vector<std::array<int, 4>>& tets, std::size_t nodes,
                                 const std::vector<std::uint8_t>& present);

}  // namespace rhexis
