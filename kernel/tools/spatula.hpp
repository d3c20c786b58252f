// SPDX-License-Identifier: GPL-3.0-or-later
// The second instrument: a nucleus manipulator that turns and holds the lens and never cuts.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// Frame: the tip of its olive is the origin, +z runs to where the wound holds the shaft, about 8 mm away. The last
/// 2.5 mm are bent down (to -y) by more than 55 degrees, so that the end stands in a groove while the shaft stays over
/// lens and rim. Olive 0.7 mm, shaft 0.5 mm across; handle from 22 mm behind the bend. Friction on lens tissue as for
/// the other steel instruments.
ToolModel spatula();

}  // namespace rhexis
