// SPDX-License-Identifier: GPL-3.0-or-later
// How much of an image something was seen in.
#pragma once

#include <span>
#include <vector>

#include "math/types.hpp"

namespace rhexis::tracking {

/// How much of the image points fell into: cells that have any.
struct Coverage {
    int columns = 8;
    int rows = 6;
    std::vector<int> points{};  ///< of each cell, row by row

    /// Share of cells with points, 0 to 1.
    [[nodiscard]] double share() const;
};

Coverage coverage_of(std::span<const Vec2> points, int width, int height);

}  // namespace rhexis::tracking
