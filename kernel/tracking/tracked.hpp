// SPDX-License-Identifier: GPL-3.0-or-later
// markers -> poses: what tracking says of each body, exposure by exposure.
#pragma once

#include <cstdint>
#include <vector>

#include "math/types.hpp"

namespace rhexis::tracking {

enum class Seen : std::uint8_t {
    lost,  ///< nothing is known; pose is the last one that was
    held,  ///< not seen now: pose is where it was going, for at most Tracker's hold time
    seen,
};

struct TrackedBody {
    Seen seen = Seen::lost;
    Pose pose{};             ///< of the body's frame, in the eye's where a head is tracked, else in the rig [mm]
    Pose tip{};              ///< of the instrument's tip, in the same frame
    double time_s = 0.0;     ///< of the exposures that it comes from
    int cameras = 0;         ///< that saw at least one of its markers
    int markers = 0;         ///< that were seen by at least one camera
    double residual_px = 0;  ///< root mean square over what it was fitted to
};

/// All bodies, in the order in which the tracker was given them.
struct TrackedBodies {
    double time_s = 0.0;
    std::vector<TrackedBody> bodies{};
};

}  // namespace rhexis::tracking
