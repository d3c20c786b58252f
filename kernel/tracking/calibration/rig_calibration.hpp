// SPDX-License-Identifier: GPL-3.0-or-later
// A whole rig, calibrated from what its cameras see of a waved wand.
#pragma once

#include <functional>

#include "tracking/calibration/calibration_report.hpp"
#include "tracking/setup.hpp"

namespace rhexis::tracking {

/// What was seen of a wand so far.
struct WandLook {
    double share = 0.0;                         ///< of the time; 1: it is over
    const std::vector<CameraSpots>& exposures;  ///< the last ones
    std::shared_ptr<const FrameSet> images{};   ///< that they are of; null: there are none
    std::span<const WandFrame> frames{};        ///< all so far
};

/// Of each camera that sees as many whole spheres as the wand has: half of one, or two that touch, would be beside.
WandFrame wand_frame(const std::vector<CameraSpots>& exposures, std::size_t spheres);

/// Takes the setup's wand until its source ends or `seconds` have passed; look is called after each exposure and once
/// at the end, and says whether to go on. Lenses are the rig's own, refined where `refine_lenses`; a synthetic rig
/// whose lenses nobody measured has them from noisy views of a board first. The error: that of calibrate_wand(),
/// calibrate_lens() or the source, or it was not to go on.
Result<CalibrationReport> calibrate_setup(const Setup& setup, double seconds, bool refine_lenses,
                                          const std::function<bool(const WandLook&)>& look);

}  // namespace rhexis::tracking
