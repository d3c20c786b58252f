// SPDX-License-Identifier: GPL-3.0-or-later
// How soon a camera that was knocked is named, and whether one is that was not.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tracking/camera_health.hpp"
#include "tracking/synthetic/clips.hpp"
#include "tracking/synthetic/synthetic_rig.hpp"

namespace rhexis::tracking {

struct KnockErrors {
    double named_after_s = 0.0;  ///< that the knocked camera was named; so long as it was waited for if it never was
    int false_alarms = 0;        ///< cameras named before the knock, another than the knocked one, or without a knock
};

/// A camera is turned by 0.1 degrees at 1 s and waited for until 2.5 s; then the same clip without it. From markers,
/// without images. The errors are those of clips and of the synthetic rig.
Result<KnockErrors> measure_knock(const synthetic::SyntheticRig& rig, const Rig& solver,
                                  const std::vector<MarkerBody>& bodies, std::uint64_t seed);

}  // namespace rhexis::tracking
