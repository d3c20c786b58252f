// SPDX-License-Identifier: GPL-3.0-or-later
// The input stage: whatever gives samples (a virtual surgeon, a recording, a test, a person's devices), they are
// checked here and nowhere else.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/device_sample.hpp"

namespace rhexis {

/// Farthest that a tip may be from the centre of the eye [mm].
inline constexpr double sample_reach_mm = 200.0;

/// Checks a sample and makes its orientation a unit quaternion (a length within 1 % of 1 is taken as rounding).
/// instruments: number of instruments of the scene. The error names the field, its value and its range.
Result<DeviceSample> checked_sample(const DeviceSample& sample, int instruments);

struct RefusedSample {
    int instrument = 0;  ///< as given; there may be no such one
    std::string why;
};

/// What one step is given.
struct StepInput {
    std::vector<std::optional<DeviceSample>> samples;  ///< by instrument; none: it stays as it was
    std::vector<RefusedSample> refused;
};

/// Takes the samples of a step, checked; of several for one instrument, the last that makes sense.
StepInput read_samples(std::span<const DeviceSample> given, int instruments);

}  // namespace rhexis
