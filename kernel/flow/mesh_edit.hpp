// SPDX-License-Identifier: GPL-3.0-or-later
// topology -> session: a change of connectivity as a value, applied once.
#pragma once

#include <vector>

namespace rhexis {

struct MeshEdit {
    int solid = 0;
    std::vector<int> removed_fine;    ///< fine tetrahedra that are gone from this step on, ascending
    std::vector<int> removed_coarse;  ///< coarse tetrahedra whose 8 children are all gone, ascending
    [[nodiscard]] bool empty() const { return removed_fine.empty() && removed_coarse.empty(); }
};

}  // namespace rhexis
