// SPDX-License-Identifier: GPL-3.0-or-later
// One camera's lens, from images of a flat board of dots or of chess fields.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "tracking/camera.hpp"
#include "tracking/spot.hpp"

namespace rhexis::tracking {

enum class GridKind : std::uint8_t {
    chess,  ///< inner corners of chess fields
    dots,   ///< centres of dark dots in rows and columns
};

struct GridPlan {
    int columns = 0;          ///< of points; 3 to 100
    int rows = 0;             ///< likewise; a chess board has one field more each way
    double spacing_mm = 0.0;  ///< between neighbours
    GridKind kind = GridKind::dots;
};

/// A board's points in one image, row by row [pixels].
struct BoardView {
    std::string name{};  ///< the image's, for errors
    int width = 0;       ///< of the image [pixels]
    int height = 0;
    std::vector<Vec2> points{};
};

/// The board's points in an image; none: it is not wholly in it.
std::optional<BoardView> find_board(const GreyImage& image, const GridPlan& plan, const std::string& name);

/// How much of the image points fell into: cells that have any.
struct Coverage {
    int columns = 8;
    int rows = 6;
    std::vector<int> points{};  ///< of each cell, row by row

    /// Share of cells with points, 0 to 1.
    [[nodiscard]] double share() const;
};

Coverage coverage_of(std::span<const Vec2> points, int width, int height);

struct LensSettings {
    int fewest_views = 8;             ///< after bad ones were left out
    int fewest_slanted = 3;           ///< views whose nearest and farthest points differ clearly in depth
    double least_slant = 0.04;        ///< that difference, as a share of the depth
    double least_coverage = 0.6;      ///< share of the image's cells
    double bad_view = 3.0;            ///< times the median view's residual: left out
    double most_residual_px = 0.5;    ///< of what is left
    double most_focal_sigma = 0.005;  ///< standard deviation of the focal length, as a share
};

struct BoardFit {
    bool used = false;
    double residual_px = 0.0;  ///< root mean square of the distance; the last known of one that is left out
};

struct LensCalibration {
    Lens lens{};
    int width = 0;
    int height = 0;
    double residual_px = 0.0;       ///< root mean square of the distance over all points of used views
    double focal_sigma_px = 0.0;    ///< standard deviation of fx
    std::vector<BoardFit> views{};  ///< as they were given
    Coverage coverage{};
};

/// [Zhang2000], with views that fit badly left out one after the other. The error: too few views, images of unequal
/// size, points in too little of the image, boards all parallel to the image (which say nothing of the focal length),
/// or a residual that is no lens's.
Result<LensCalibration> calibrate_lens(std::span<const BoardView> views, const GridPlan& plan,
                                       const LensSettings& settings = {});

}  // namespace rhexis::tracking
