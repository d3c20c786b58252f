// SPDX-License-Identifier: GPL-3.0-or-later
// What the cameras see and what was made of it, as one picture for a person.
#pragma once

#include <string>

#include "tracking/setup.hpp"

namespace rhexis::tracking {

/// A PNG file with all cameras' last exposures beside each other: images where there are any, a ring around each spot,
/// and a cross with its name where each body's markers should be. `head_in_rig` brings poses back to the rig.
Status write_annotated(const std::string& path, const Setup& setup, const std::vector<CameraSpots>& exposures,
                       const FrameSet* images, const std::vector<Pose>& bodies_in_rig, const std::vector<bool>& seen);

}  // namespace rhexis::tracking
