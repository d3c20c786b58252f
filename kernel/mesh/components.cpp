// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/components.hpp"

namespace rhexis {

std::vector<int> pieces_by_nodes(const std::vector<std::array<int, 4>>& tets, std::size_t nodes,
                                 const std::vector<std::uint8_t>& present) {
    const int count = static_cast<int>(tets.size());
    UnionFind sets(count);
    std::vector<int> first(nodes, -1);
    for (int t = 0; t < count; ++t) {
        if (present[t] != 0) {
            for (const int node : tets[t]) {
                first[node] = first[node] < 0 ? t : first[node];
                sets.join(first[node], t);
            }
        }
    }
    std::vector<int> pieces(tets.size(), -1);
    for (int t = 0; t < count; ++t) {
        pieces[t] = present[t] != 0 ? sets.find(t) : -1;
    }
    return pieces;
}

}  // namespace rhexis
