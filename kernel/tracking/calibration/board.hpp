// SPDX-License-Identifier: GPL-3.0-or-later
// The flat board by which lenses are calibrated, and what of it an image shows.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "math/types.hpp"

namespace rhexis::tracking {

enum class GridKind : std::uint8_t {
    chess,  ///< inner corners of chess fields
    dots,   ///< centres of round dots in rows and columns, bright ones on dark ground or the other way round
};

struct GridPlan {
    int columns = 0;          ///< of points; 3 to 100
    int rows = 0;             ///< likewise; a chess board has one field more each way
    double spacing_mm = 0.0;  ///< between neighbours, 0.1 to 1000
    GridKind kind = GridKind::dots;

    [[nodiscard]] int points() const { return columns * rows; }
};

/// A point's place on the board, row by row, its middle at the origin [mm].
Vec2 point_of(const GridPlan& plan, int point);

/// "dots:13x9x14" or "chess:10x7x20": columns and rows of points, and the distance between neighbours [mm]. The error
/// says what is no board, or which number is out of range.
Result<GridPlan> parse_board(std::string_view text);

Status check_board(const GridPlan& plan);

/// A board's points in one image, row by row [pixels].
struct BoardView {
    std::string name{};  ///< the image's, for errors
    int width = 0;       ///< of the image [pixels]
    int height = 0;
    std::vector<Vec2> points{};
    std::vector<double> areas{};  ///< of each point's dot [pixels]; empty: they are points, or not told
};

}  // namespace rhexis::tracking
