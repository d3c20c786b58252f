// SPDX-License-Identifier: GPL-3.0-or-later
// A first guess of where cameras stand, of pairs that saw the wand together.
#pragma once

#include <span>
#include <vector>

#include "tracking/calibration/wand_labels.hpp"

namespace rhexis::tracking {

/// How many frames each pair of cameras shares, and each camera alone on the diagonal; symmetric.
Eigen::MatrixXi shared_frames(std::span<const LabelledFrame> frames, std::size_t cameras);

/// Cameras with new poses, the first one's as it was: essential matrices between pairs [Nister2004], those that share
/// most frames first, each scaled by the wand's length. The error names the camera that could not be placed, the one
/// that never saw the wand, or two groups that share fewer than `fewest_shared` frames.
Result<std::vector<Camera>> start_of_wand(std::vector<Camera> cameras, double length_mm,
                                          std::span<const LabelledFrame> frames, int fewest_shared);

}  // namespace rhexis::tracking
