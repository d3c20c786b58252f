// SPDX-License-Identifier: GPL-3.0-or-later
// A solver's rig of the synthetic one, made as that of a real one is: lenses from a board, poses from a waved wand.
#pragma once

#include <cstdint>

#include "base/result.hpp"
#include "tracking/calibration/wand.hpp"
#include "tracking/synthetic/synthetic_rig.hpp"

namespace rhexis::tracking {

struct CalibrationPlan {
    std::uint64_t seed = 1;        ///< of the boards' places, the wand's way and all noise
    int boards = 36;               ///< views of a board of 9 x 7 points for each camera, at least 8
    double board_sigma_px = 0.02;  ///< noise of a board's points in an image, each way
    bool board_images = false;     ///< boards are rendered and their dots are found; else noisy points
    int wand_frames = 600;         ///< at least 50
    double wand_rate_hz = 20.0;    ///< exposures a second
    bool images = false;           ///< the wand is rendered and its spots are found; else spots without images
    double wand_error_mm = 0.0;    ///< by which the wand is longer than the solver believes
};

struct SyntheticCalibration {
    Rig rig{};                       ///< what a tracker may know
    double board_residual_px = 0.0;  ///< root mean square of the distance, of the worst camera
    double wand_residual_px = 0.0;   ///< as WandCalibration::residual_px
    double scale_sigma = 0.0;        ///< as WandCalibration::scale_sigma
    double seconds = 0.0;            ///< as WandCalibration::seconds
    int iterations = 0;              ///< likewise
    double scale_error = 0.0;        ///< share by which true distances about the eye come out too great
    double bend_mm = 0.0;            ///< root mean square over points about the eye, a rigid motion taken away
};

/// Nothing of the true cameras reaches `rig` but by noisy images of boards and of the wand. The errors are those of
/// calibrate_lens(), film_images() and calibrate_wand().
Result<SyntheticCalibration> calibrate_synthetic(const synthetic::SyntheticRig& rig, const CalibrationPlan& plan);

}  // namespace rhexis::tracking
