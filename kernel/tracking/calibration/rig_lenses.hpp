// SPDX-License-Identifier: GPL-3.0-or-later
// The lenses of a whole rig, from images of a board that was shown to each camera.
#pragma once

#include <functional>

#include "tracking/calibration/lens_calibration.hpp"
#include "tracking/setup.hpp"

namespace rhexis::tracking {

struct BoardsPlan {
    GridPlan board{};
    int views = 40;               ///< of the board that each camera takes, at most; 8 to 400
    double seconds = 300.0;       ///< for which images are looked at, at most
    double least_move_px = 10.0;  ///< by which a board's points moved since the view before; else it is no other view
    LensSettings lens{};
};

/// What one camera saw of the board.
struct SeenBoards {
    std::vector<BoardView> views{};
    std::vector<std::string> without{};  ///< images in which the board was not found
    int alike = 0;                       ///< views that were left out: nothing had moved
};

/// Until the source ends, every camera has its views, or time is over. Progress is told the share that is done. An
/// image is called as its file is, or by its camera and its number.
Result<std::vector<SeenBoards>> look_for_boards(FrameSource& source, const Rig& rig, const BoardsPlan& plan,
                                                const std::function<void(double)>& progress);

struct RigLenses {
    Rig rig{};  ///< with lenses and Rig::lenses; not calibrated, since places were found with other lenses
    std::vector<SeenBoards> seen{};               ///< by each camera
    std::vector<LensCalibration> calibrations{};  ///< likewise
};

/// All lenses of a rig, or none: the error names the camera that never saw a board, or whose views do not determine its
/// lens, and why; see calibrate_lens().
Result<RigLenses> calibrate_lenses(const Rig& given, std::vector<SeenBoards> seen, const BoardsPlan& plan);

}  // namespace rhexis::tracking
