// SPDX-License-Identifier: GPL-3.0-or-later
// The handpiece that irrigates and aspirates, without ultrasound.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// A coaxial tip of 0.8 mm with a round closed end and a mouth of 0.3 mm in its side, which looks along its own +y
/// axis: up, as hands hold it. Fluid comes in through a sleeve around it; where makes no difference here. [mm]
ToolModel ia_tip();

}  // namespace rhexis
