// SPDX-License-Identifier: GPL-3.0-or-later
// topology -> session: a change of connectivity as a value, applied once.
#pragma once

#include <array>
#include <vector>

namespace rhexis {

/// Two coarse tetrahedra, the lower first, whose common face holds them together no more.
using BrokenFace = std::array<int, 2>;

/// A node came apart: these of its tetrahedra hang on a new node at the end of the list, the others keep it.
struct NodeSplit {
    int node = 0;
    std::vector<int> tets;  ///< ascending
};

struct MeshEdit {
    int solid = 0;
    std::vector<int> removed_fine;        ///< fine tetrahedra that are gone from this step on, ascending
    std::vector<int> removed_coarse;      ///< coarse tetrahedra whose 8 children are all gone, ascending
    std::vector<BrokenFace> broken = {};  ///< ascending
    std::vector<NodeSplit> splits = {};   ///< in the order in which they are made
    [[nodiscard]] bool empty() const {
        return removed_fine.empty() && removed_coarse.empty() && broken.empty() && splits.empty();
    }
};

}  // namespace rhexis
