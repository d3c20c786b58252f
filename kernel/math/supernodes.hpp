// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows of a sparse Cholesky factor share a pattern: the tree of dense panels that a factorisation works through.
#pragma once

#include <span>
#include <vector>

#include "math/block_matrix.hpp"

namespace rhexis {

/// Panels of consecutive block columns, children before parents. Panel s has the columns first[s] .. first[s + 1] - 1
/// and below them the block rows row[row_first[s]] .. row[row_first[s + 1] - 1], ascending.
struct Supernodes {
    std::vector<int> first;
    std::vector<int> row_first;
    std::vector<int> row;
    std::vector<int> parent;  ///< panel that takes over what this one leaves, or -1

    [[nodiscard]] int count() const { return static_cast<int>(parent.size()); }
    [[nodiscard]] int width(int s) const {
        return first[static_cast<std::size_t>(s) + 1] - first[static_cast<std::size_t>(s)];
    }
    [[nodiscard]] int below(int s) const {
        return row_first[static_cast<std::size_t>(s) + 1] - row_first[static_cast<std::size_t>(s)];
    }
};

/// pattern: rows in an order of elimination; a postordered one (elimination_order gives one) has fewer and wider
/// panels. Small panels are merged with their parents where that adds few zeros [Davis2006].
Supernodes find_supernodes(const BlockPattern& pattern);

/// Follows a matrix to which rows were added, each to the panel of the row in front of it; rows below panels that are
/// no more needed stay. row_now: per row before, ascending. False if there are entries that this leaves no place for:
/// then nothing of the tree is of use.
bool grow(Supernodes& tree, const BlockPattern& pattern, std::span<const int> row_now);

}  // namespace rhexis
