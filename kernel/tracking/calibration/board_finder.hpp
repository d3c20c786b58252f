// SPDX-License-Identifier: GPL-3.0-or-later
// Where an image shows the points of a board.
#pragma once

#include <optional>
#include <string>

#include "tracking/calibration/board.hpp"
#include "tracking/spot.hpp"

namespace rhexis::tracking {

/// The board's points in an image; none: it is not wholly in it. Dots are found as spots of spheres are, by the rims of
/// their images, bright ones on dark ground or else dark ones on bright ground, and put into rows by OpenCV's
/// findCirclesGrid(); corners of fields by findChessboardCornersSB() [Duda2018], then cornerSubPix(). Which corner
/// comes first, and so a half turn of the board, is not told.
std::optional<BoardView> find_board(const GreyImage& image, const GridPlan& plan, const std::string& name);

}  // namespace rhexis::tracking
