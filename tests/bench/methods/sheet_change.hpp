// SPDX-License-Identifier: GPL-3.0-or-later
// What splits change in a matrix that was factored before them. Its triangles keep the stiffness that they had when
// they came into it: those that a split takes away leave as they were, those that it makes come in as they are.
#pragma once

#include <unordered_map>
#include <vector>

#include "bench/methods/split_system.hpp"

namespace rhexis::bench {

/// A symmetric matrix over a few nodes that move.
struct NodeMatrix {
    std::vector<int> nodes;  ///< ascending
    MatX value;              ///< 3 rows and columns per node
};

class SheetChange {
public:
    /// The matrix is that of this system.
    void start(const SplitSystem& system);
    /// What to add to it for the sheet of the next system to be in it.
    NodeMatrix follow(const SplitSystem& system);

private:
    MembraneState state_;                    ///< at the start
    std::vector<std::array<int, 3>> nodes_;  ///< of the triangles now in the matrix
    std::unordered_map<int, Mat9> added_;    ///< shares of those that came in since the start
};

}  // namespace rhexis::bench
