// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments whose last part is bent down at a right angle to their shaft.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// A bent end of a length and radii, a shaft from there to the hand, and a handle. The end is the first part. The tip
/// is the origin, so that a hand that holds the shaft level with the wound has its point straight down; the shaft comes
/// from the wound along -y and rises by a tenth. A probe until its maker says otherwise. [mm]
ToolModel bent_tool(const char* name, double length, double point, double shaft);

}  // namespace rhexis
