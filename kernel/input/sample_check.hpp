// SPDX-License-Identifier: GPL-3.0-or-later
// A sample from outside is used only when every number in it makes sense; otherwise the instrument stays as it was.
#pragma once

#include "base/result.hpp"
#include "flow/device_sample.hpp"

namespace rhexis {

/// Farthest that a tip may be from the centre of the eye [mm].
inline constexpr double sample_reach_mm = 200.0;

/// Checks a sample and makes its orientation a unit quaternion (a length within 1 % of 1 is taken as rounding).
/// instruments: number of instruments of the scene. The error names the field, its value and its range.
Result<DeviceSample> checked_sample(const DeviceSample& sample, int instruments);

}  // namespace rhexis
