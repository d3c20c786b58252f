// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's modules in Lua: the global `rhexis` with mesh, scene, render and eye. Described, function by function,
// in bindings/lua/meta/, from which docs/api.md is made. Units are the kernel's: mm, g, s, so uN, Pa, nJ.
#pragma once

#include <lauxlib.h>
#include <lua.h>

#include <vector>

namespace rhexis::lua {

/// Inside LuaState::run: sets the global and makes `require "rhexis"` find it too.
void open_modules(lua_State* L);

// One file each: pushes the module's table and defines its classes.
void push_mesh_module(lua_State* L);
void push_scene_module(lua_State* L);
void push_render_module(lua_State* L);
void push_eye_module(lua_State* L);

// Parts of the scene module (scene_add.cpp).
std::vector<luaL_Reg> scene_creators();  ///< its functions
std::vector<luaL_Reg> scene_adders();    ///< methods of Scene that add something

// Classes that the scene module uses, in files of their own.
void define_membrane_class(lua_State* L);  ///< Membrane (membrane_class.cpp)
void define_solid_class(lua_State* L);     ///< Solid and View (solid_class.cpp)
void define_tool_class(lua_State* L);      ///< tool_class.cpp

}  // namespace rhexis::lua
