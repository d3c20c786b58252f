// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes or elements a script means: a function of the place, a box, or a list of numbers (from 1, as in Lua).
#pragma once

#include <lua.h>

#include <string>
#include <vector>

#include "math/types.hpp"

namespace rhexis::lua {

/// The value at index against `points`:
///   function(x, y, z) -> true for those meant;  {low = {x, y, z}, high = {x, y, z}} -> those inside, border included;
///   {3, 4, 8} -> those numbers;  nil -> none.
/// Indices from 0, ascending, each once. `what` names the argument in errors.
std::vector<int> read_selection(lua_State* L, int index, const std::vector<Vec3>& points, const std::string& what);

/// The same, but what is given must mean at least one.
std::vector<int> read_some(lua_State* L, int index, const std::vector<Vec3>& points, const std::string& what);

/// Pushes indices as a list of numbers from 1.
void push_numbers(lua_State* L, const std::vector<int>& indices);

/// The integer at index as an index from 0 into `count` things.
int check_number_of(lua_State* L, int index, std::size_t count);

}  // namespace rhexis::lua
