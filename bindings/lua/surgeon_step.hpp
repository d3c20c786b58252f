// SPDX-License-Identifier: GPL-3.0-or-later
// What a virtual surgeon does in one step.
#pragma once

#include <vector>

#include "flow/command.hpp"
#include "flow/device_sample.hpp"

namespace rhexis {

struct SurgeonStep {
    std::vector<DeviceSample> samples;
    std::vector<Command> requests;  ///< of the staff
};

}  // namespace rhexis
