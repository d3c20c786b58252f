// SPDX-License-Identifier: GPL-3.0-or-later
// What a lens's blur does to a part of an image.
#pragma once

#include <vector>

namespace rhexis::tracking::synthetic {

inline constexpr double blur_reach = 4.0;  ///< standard deviations; beyond, it is nothing

/// By a bell of standard deviation `sigma` [pixels], above 0, line by line and column by column; nothing is beyond the
/// rims. `values`: width * height, line by line. `line`: scratch.
void blur(std::vector<float>& values, int width, int height, double sigma, std::vector<float>& line);

}  // namespace rhexis::tracking::synthetic
