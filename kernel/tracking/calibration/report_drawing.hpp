// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of the calibration's page, as SVG inside HTML, and how text is put into it.
#pragma once

#include <string>
#include <string_view>

#include "tracking/calibration/coverage.hpp"
#include "tracking/calibration/wand.hpp"

namespace rhexis::tracking {

/// Text as HTML shows it: no character of it is read as a mark.
std::string escaped(std::string_view text);

/// A number with so many digits after the point; "-" for what is none.
std::string fixed_text(double value, int decimals);

std::string page_style();

/// A bar for each camera, and a line at the goal.
std::string residual_bars(const WandCalibration& wand, double goal_px);

/// The image's cells, darker where more points fell.
std::string coverage_map(const Camera& camera, const Coverage& coverage);

/// Cameras and what they see across, in the plane of the rig's x and y, as far as the middle of all views.
std::string rig_from_above(const Rig& rig);

}  // namespace rhexis::tracking
