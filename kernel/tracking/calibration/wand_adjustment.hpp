// SPDX-License-Identifier: GPL-3.0-or-later
// Bundle adjustment of cameras, of the wand's places and of its length.
#pragma once

#include <array>
#include <vector>

#include "tracking/calibration/wand_labels.hpp"

namespace rhexis::tracking {

/// What is adjusted: cameras (the first one's pose is held), the wand's ends in each frame, and its length.
struct WandEstimate {
    std::vector<Camera> cameras{};
    std::vector<LabelledFrame> frames{};
    std::vector<std::array<double, 6>> ends{};  ///< of each frame: first end, last end [mm]
    double length_mm = 0.0;
};

struct WandCertainty {
    std::vector<double> position_sigma_mm{};  ///< of each camera; 0 for the first
    double length_sigma_mm = 0.0;
};

/// The frames' ends where rays meet.
WandEstimate wand_estimate(std::vector<Camera> cameras, std::vector<LabelledFrame> frames, double length_mm);

/// One spot's distance from where the estimate has it; infinite where that is behind the camera.
struct SpotOff {
    std::size_t frame = 0;
    int camera = 0;
    Vec2 off = Vec2::Zero();  ///< [pixels]
};
std::vector<SpotOff> spot_offs(const WandEstimate& estimate, const Wand& wand);

/// Greatest distance between a spot and where the estimate has it [pixels], of each frame.
std::vector<double> worst_residuals(const WandEstimate& estimate, const Wand& wand);

/// Removes frames whose worst residual is over `factor` times the median's one; how many.
int drop_outliers(WandEstimate& estimate, const Wand& wand, double factor);

/// Adjusts in place as adjust() does, but only until a step takes off less than a hundredth of what is left: near
/// enough to tell frames that do not fit, which a whole adjustment would creep after. The number of iterations.
int approach(WandEstimate& estimate, const Wand& wand, const WandSettings& settings);

/// Adjusts in place, by Levenberg-Marquardt steps and with Huber's loss [Triggs2000]; the number of iterations. The
/// error: it did not converge.
Result<int> adjust(WandEstimate& estimate, const Wand& wand, const WandSettings& settings);

/// Standard deviations of an estimate that was adjusted; the error: its equations are singular.
Result<WandCertainty> certainty_of(const WandEstimate& estimate, const Wand& wand, const WandSettings& settings);

}  // namespace rhexis::tracking
