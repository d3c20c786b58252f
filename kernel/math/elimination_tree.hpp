// SPDX-License-Identifier: GPL-3.0-or-later
// What eliminating the rows of a symmetric matrix one after the other leads to: which column each one changes next, and
// where the factor has entries [Liu1990].
#pragma once

#include <vector>

#include "math/block_matrix.hpp"

namespace rhexis {

/// Compressed columns of a factor without its diagonal: column j has the rows row[first[j]] .. row[first[j + 1] - 1],
/// ascending.
struct FactorRows {
    std::vector<int> first;
    std::vector<int> row;
};

/// The column that each one changes first, or -1; rows in the order of elimination.
std::vector<int> elimination_tree(const BlockPattern& pattern);

/// Rows of the factor's columns, for the tree of the same pattern.
FactorRows factor_rows(const BlockPattern& pattern, const std::vector<int>& tree);

}  // namespace rhexis
