// SPDX-License-Identifier: GPL-3.0-or-later
// Lua values to and from JSON. Objects come out sorted by key, so the same table always gives the same text.
#pragma once

#include <lua.h>

#include <nlohmann/json.hpp>

namespace rhexis::lua {

/// The value at index. A table with keys 1..n is an array, one with text keys an object; an empty table is an array
/// unless its metatable has __json = "object". nil and numbers that are not finite become null. Raises, with the path
/// of the field, on functions, userdata, mixed keys, holes, and tables nested deeper than 64 (cycles).
nlohmann::json to_json(lua_State* L, int index);

/// Pushes; null becomes nil, so such fields of objects are absent.
void push_json(lua_State* L, const nlohmann::json& value);

}  // namespace rhexis::lua
