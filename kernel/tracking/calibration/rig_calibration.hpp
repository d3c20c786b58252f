// SPDX-License-Identifier: GPL-3.0-or-later
// A whole rig, calibrated from what its cameras see of a waved wand.
#pragma once

#include <functional>

#include "tracking/calibration/calibration_report.hpp"
#include "tracking/setup.hpp"

namespace rhexis::tracking {

/// Takes the setup's wand until its source ends or `seconds` have passed; progress is told the share of it that is
/// done. Lenses of a synthetic rig come from boards held before its cameras; those of others are the rig's own, refined
/// where `refine_lenses`. The error: that of calibrate_wand(), calibrate_lens() or the source.
Result<CalibrationReport> calibrate_setup(const Setup& setup, double seconds, bool refine_lenses,
                                          const std::function<void(double)>& progress);

}  // namespace rhexis::tracking
