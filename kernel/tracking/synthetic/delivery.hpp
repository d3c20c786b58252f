// SPDX-License-Identifier: GPL-3.0-or-later
// When cameras expose and when that is known: lost, late and reordered frames, clocks that are not alike.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.hpp"
#include "tracking/synthetic/synthetic_rig.hpp"

namespace rhexis::tracking::synthetic {

struct Delivery {
    double rate_hz = 120.0;      ///< 1 to 1000
    double exposure_s = 0.5e-3;  ///< 0 to 1/rate
    double skew_s = 0.0;         ///< cameras expose one after another, that much from first to last; told truly
    double lost = 0.0;           ///< probability of a frame that never comes, of each camera
    double delay_s = 2e-3;       ///< from the middle of the exposure to its arrival, at least
    double jitter_s = 0.5e-3;    ///< mean of what is added to it, distributed exponentially
    double late = 0.0;           ///< probability of a frame that comes later still, after others that are newer
    double late_s = 20e-3;       ///< by how much
};

/// One camera's exposure.
struct Shot {
    int camera = 0;
    std::int64_t frame = 0;
    double exposed_s = 0.0;  ///< true middle of the exposure
    double time_s = 0.0;     ///< the middle as the camera tells it: without its own time offset
    double arrives_s = 0.0;
};

/// Shots of this many frames that are not lost, in the order of arrival. The error names what is out of range.
Result<std::vector<Shot>> shots(const SyntheticRig& rig, const Delivery& delivery, int frames, std::uint64_t seed);

}  // namespace rhexis::tracking::synthetic
