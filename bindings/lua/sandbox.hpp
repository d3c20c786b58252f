// SPDX-License-Identifier: GPL-3.0-or-later
// What a script finds in its globals.
//
// LuaKind::sandbox: base, table, string, math, utf8, coroutine without load, loadfile, dofile, collectgarbage, warn and
// string.dump; no debug, io, os, package. `require` reads only the state's script folders. Replaced:
//   pairs, next         walk in a fixed order: numbers, then strings, then booleans; see ordered.cpp
//   table.sort          stable, and the same in every run (the stock one draws pivots from the clock)
//   tostring, format    show no address
//   math.random         the state's own stream
//   setmetatable        refuses __gc (a finaliser cannot be interrupted) and __mode (it would show the collector's
//   pace) string.find, match, gmatch, gsub, rep and table.move, insert, remove, concat: their work counts in the budget
//   pcall, xpcall, coroutine.resume, wrap: cannot swallow the end of the budget
//   print               goes to the state's sink
//
// LuaKind::script: all standard libraries, with the same pairs, next, table.sort, tostring, math.random and print.
#pragma once

#include <lua.h>

namespace rhexis::lua {

/// Inside LuaState::run: opens what context(L).options.kind allows.
void open_libraries(lua_State* L);

// Parts of it, one file each. All act on the globals.
void open_order(lua_State* L);       ///< pairs, next, table.sort, tostring, print (ordered.cpp)
void open_random(lua_State* L);      ///< math.random, math.randomseed (random.cpp)
void open_strings(lua_State* L);     ///< pattern functions, rep, format (strings.cpp)
void open_tables(lua_State* L);      ///< move, insert, remove, concat (tables.cpp)
void open_protection(lua_State* L);  ///< pcall, xpcall, coroutines, setmetatable (protection.cpp)
void open_require(lua_State* L);     ///< require (require.cpp)

/// Pushes the value as print shows it: its __tostring, a plain value, or the name of its type. Never an address.
void push_text(lua_State* L, int index);

}  // namespace rhexis::lua
