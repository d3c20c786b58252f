// SPDX-License-Identifier: GPL-3.0-or-later
// One camera's lens, from images of a flat board of dots or of chess fields.
#pragma once

#include <span>
#include <vector>

#include "base/result.hpp"
#include "tracking/calibration/board.hpp"
#include "tracking/calibration/coverage.hpp"
#include "tracking/camera.hpp"

namespace rhexis::tracking {

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
    double dot_mm = 0.0;            ///< radius of the board's dots, by the areas of their images; 0: not told
    std::vector<BoardFit> views{};  ///< as they were given
    Coverage coverage{};
};

/// [Zhang2000], with views that fit badly left out one after the other; where all views tell the areas of dots, their
/// centres are taken to be where such dots' centres are seen (dot_off()), and the lens is fitted again. The error: too
/// few views, images of unequal size, points in too little of the image, boards all parallel to the image (which say
/// nothing of the focal length), or a residual that is no lens's.
Result<LensCalibration> calibrate_lens(std::span<const BoardView> views, const GridPlan& plan,
                                       const LensSettings& settings = {});

}  // namespace rhexis::tracking
