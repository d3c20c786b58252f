// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric sparse matrices of 3x3 blocks, one block row per node. The pattern is fixed, the values change.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "math/types.hpp"

namespace rhexis {

/// Compressed block rows with both triangles: row i holds columns column[first[i]] .. column[first[i + 1] - 1],
/// ascending.
struct BlockPattern {
    std::vector<int> first;
    std::vector<int> column;
    std::vector<int> diagonal;  ///< slot of (i, i)
    std::vector<int> mirror;    ///< slot of (j, i) for the slot of (i, j)

    [[nodiscard]] int rows() const { return static_cast<int>(diagonal.size()); }
    [[nodiscard]] int blocks() const { return static_cast<int>(column.size()); }
    /// Slot of (row, column), or -1.
    [[nodiscard]] int slot(int row, int column) const;
};

/// The diagonal and, for every group of nodes, all pairs in it. groups: compressed rows as in `first`, `node`.
BlockPattern block_pattern(int rows, std::span<const int> first, std::span<const int> node);

/// Fills in diagonal and mirror of a pattern whose rows and columns are known.
void find_mirrors(BlockPattern& pattern);

/// The same pattern with other numbers: row order[k] becomes k, and place is the inverse of order.
BlockPattern permuted(const BlockPattern& pattern, std::span<const int> order, std::span<const int> place);

/// Values of a pattern: 9 per slot, each block by columns; then a block that belongs to no slot, for what is to be
/// dropped, and one number of padding, so that kernels may read four at a time.
using BlockValues = std::vector<double>;
BlockValues zero_values(const BlockPattern& pattern);
/// How many numbers that is.
std::size_t values_of(const BlockPattern& pattern);

/// The block of a slot.
Mat3 block_of(const BlockValues& values, int slot);
void add_block(BlockValues& values, int slot, const Mat3& block);

/// Sets the diagonal and what is right of it to zero, in the order of slots, and the block to be dropped.
void clear_upper(const BlockPattern& pattern, BlockValues& values);
/// Copies what is right of the diagonal to the left of it.
void mirror_upper(const BlockPattern& pattern, BlockValues& values);

/// y = A x; x and y hold 3 numbers per row.
void multiply(const BlockPattern& pattern, const BlockValues& values, std::span<const double> x, std::span<double> y);

}  // namespace rhexis
