// SPDX-License-Identifier: GPL-3.0-or-later
// How far off the spots of a clip are, whether they were found in images or made without: what both levels must share.
#pragma once

#include <vector>

#include "tracking/spot.hpp"
#include "tracking/synthetic/clips.hpp"
#include "tracking/tracker.hpp"

namespace rhexis::tracking {

/// A sphere that lies within a camera's image, in one exposure.
enum class Sighted : std::uint8_t {
    missing,  ///< hidden, or no spot within 3 pixels of it
    refused,  ///< a spot that no tracker believes: a part of it, or two in one
    believed,
};
struct SightedSphere {
    int exposure = 0;
    int camera = 0;
    int body = 0;
    int marker = 0;
    Sighted sighted = Sighted::missing;
    Vec2 off = Vec2::Zero();  ///< of the spot from the centre of the ellipse that the true lens shows [pixels]
    double sigma_px = 0.0;    ///< that a tracker takes for it
};

/// Of all exposures, cameras and spheres. `recorded`: exposures of this clip by this rig.
std::vector<SightedSphere> sighted_spheres(const synthetic::SyntheticRig& rig, const synthetic::Clip& clip,
                                           const std::vector<std::vector<CameraSpots>>& recorded,
                                           const TrackerSettings& settings);

}  // namespace rhexis::tracking
