// SPDX-License-Identifier: GPL-3.0-or-later
// Which spots of different cameras are of one sphere, when nothing is known of where the spheres are.
#pragma once

#include <span>
#include <vector>

#include "tracking/points/triangulation.hpp"
#include "tracking/spot.hpp"

namespace rhexis::tracking {

struct MatchingSettings {
    double tolerance_px = 2.0;   ///< from a spot to the other camera's line of sight
    int least_views = 3;         ///< of a new point; two meet by chance too often
    double farthest_mm = 400.0;  ///< from the rig's origin
};

struct MatchedPoint {
    Vec3 point = Vec3::Zero();  ///< in the rig [mm]
    double residual_px = 0.0;
    std::vector<View> views{};  ///< at most one of each camera
};

/// Points that at least `least_views` cameras see, those of most views and then of the least residual first; no spot is
/// in two of them. `taken`, by camera and spot, are left out.
std::vector<MatchedPoint> match_spots(std::span<const Camera> cameras, std::span<const CameraSpots> exposures,
                                      const std::vector<std::vector<bool>>& taken, const MatchingSettings& settings);

}  // namespace rhexis::tracking
