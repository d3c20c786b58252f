// SPDX-License-Identifier: GPL-3.0-or-later
// The pattern of a matrix to which rows were added and of which a few rows changed: what is left alone is moved, not
// made anew.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "math/block_matrix.hpp"

namespace rhexis {

/// Where what a pattern had is in the one that came from it.
struct GrownPattern {
    BlockPattern pattern;
    std::vector<int> slot_now;  ///< per slot before, and of the block to be dropped; -1: gone
};

/// rows: how many there are now. row_now: per row before, ascending. changed: per row now, whether its columns are
/// those of `entries`, pairs of row and column in any order, again and again; all that is new must be there. The
/// columns of the others are those they were.
GrownPattern grown_pattern(const BlockPattern& before, int rows, std::span<const int> row_now,
                           const std::vector<std::uint8_t>& changed, std::vector<std::array<int, 2>> entries);

}  // namespace rhexis
