// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tool is, as scripts say it: the place of its tip, the direction from the tip to the hand, and its roll.
#pragma once

#include "lua/stack.hpp"
#include "math/types.hpp"

namespace rhexis::lua {

/// Fields position {x, y, z} [mm], axis {x, y, z} (any length) and roll [degrees, -360 to 360]; those left out stay as
/// they are in `pose`. Giving axis or roll sets both (roll 0 by default).
void read_pose(lua_State* L, Options& options, Pose& pose);

/// From the tip to the hand, unit.
Vec3 tool_axis(const Pose& pose);

}  // namespace rhexis::lua
