// SPDX-License-Identifier: GPL-3.0-or-later
// How others find spots: by OpenCV's threshold, and binary moments of its contours or its connected components. To
// compare with; no tracker uses them.
#pragma once

#include <vector>

#include "tracking/spot.hpp"

namespace rhexis::tracking {

/// threshold(), findContours(), moments() of each outer contour; every pixel from `threshold` on weighs the same.
/// Regions of fewer than 12 or more than 4000 pixels are left out.
std::vector<Spot> contour_spots(const GreyImage& image, int threshold);

/// threshold(), connectedComponentsWithStats() and its centroids, likewise. Roundness is not told: it is 1.
std::vector<Spot> component_spots(const GreyImage& image, int threshold);

}  // namespace rhexis::tracking
