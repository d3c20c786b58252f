// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: shafts off the middle of their wounds deflect the cornea, roll the globe and stretch the wounds.
#pragma once

#include <optional>
#include <span>

#include "flow/tool.hpp"
#include "flow/world.hpp"

namespace rhexis {

/// Where a shaft passes a wound.
struct ShaftAtWound {
    Vec3 off = Vec3::Zero();   ///< from the middle of the inner lip to the shaft's axis, across it [mm]
    Vec3 axis = Vec3::Zero();  ///< unit, towards the hand
    std::size_t lip = 0;
};

/// The wound that an instrument stands in, none where its tip is not behind the cornea or its shaft passes no wound.
std::optional<ShaftAtWound> shaft_at_wound(const WorldModel& model, const WorldState& state, int tool,
                                           const ToolState& tool_state);

/// Inner lip of a wound as it is now [mm].
Vec3 lip_place(const WorldModel& model, const WorldState& state, std::size_t lip);

/// One step. Poses of the tools are those of the eye's frame as it lay before.
void roll_globe(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state);

/// What wounds let through because thin shafts press on their lips, all together [mm^3/(s Pa)].
double pressed_open(const WorldModel& model, std::span<const ToolState> tools, const WorldState& state);

}  // namespace rhexis
