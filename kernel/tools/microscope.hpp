// SPDX-License-Identifier: GPL-3.0-or-later
// What a device sample makes of the microscope in one step.
#pragma once

#include <string>

#include "flow/device_sample.hpp"
#include "flow/microscope.hpp"

namespace rhexis {

inline constexpr double microscope_across_speed = 4.0;  ///< of its motors, at most [mm/s]. Proposal
inline constexpr double microscope_focus_speed = 2.0;   ///< along the view [mm/s]. Proposal
inline constexpr double microscope_reach = 25.0;        ///< from the eye's middle, each direction [mm]. Proposal

struct MicroscopeStep {
    MicroscopeState state;
    std::string rejected;  ///< why the sample was not used, one line; empty if it was
};

/// The microscope at the end of a step of dt [s]. sample.pose.position: where the foot sends it, which it nears at its
/// motors' speed; not present: the foot is off the pedal, it stays. A position that is not finite or out of reach is
/// rejected, and it stays.
MicroscopeStep next_microscope(const MicroscopeState& previous, const DeviceSample& sample, double dt);

}  // namespace rhexis
