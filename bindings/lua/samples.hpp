// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments and commands as scripts hand them over.
#pragma once

#include <lua.h>

#include <vector>

#include "flow/command.hpp"
#include "flow/device_sample.hpp"
#include "flow/observation.hpp"

namespace rhexis::lua {

/// The { x, y, z } on top of the stack.
Vec3 place_from(lua_State* L);
/// The { w, x, y, z } on top of the stack.
Quat orientation_from(lua_State* L);

/// The list of { instrument, present, position, orientation = { w, x, y, z }, jaw, pedal } on top of the stack.
std::vector<DeviceSample> samples_from(lua_State* L);

/// The list of { kind, name, value, text } on top of the stack.
std::vector<Command> commands_from(lua_State* L);

/// Overwrites the list on top of the stack with the values of an observation.
void fill_row(lua_State* L, const Observation& observation);

}  // namespace rhexis::lua
