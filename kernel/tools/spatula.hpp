// SPDX-License-Identifier: GPL-3.0-or-later
// The second instrument: a nucleus manipulator that turns and holds the lens and never cuts.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// Frame: the foremost point of the rounded end is the origin, +z runs along the shaft to the hand. The last 1.2 mm are
/// bent towards -y by 12 degrees, so the end lies lower than the shaft. End 0.4 mm, shaft 0.5 mm across; handle from
/// 22 mm. Friction on lens tissue as for the other steel instruments.
ToolModel spatula();

}  // namespace rhexis
