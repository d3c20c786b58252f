// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/modules.hpp"

#include <lauxlib.h>

namespace rhexis::lua {

void open_modules(lua_State* L) {
    lua_newtable(L);
    push_mesh_module(L);
    lua_setfield(L, -2, "mesh");
    push_scene_module(L);
    lua_setfield(L, -2, "scene");
    push_render_module(L);
    lua_setfield(L, -2, "render");
    push_eye_module(L);
    lua_setfield(L, -2, "eye");
    luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
    lua_pushvalue(L, -2);
    lua_setfield(L, -2, "rhexis");
    lua_pop(L, 1);
    lua_setglobal(L, "rhexis");
}

}  // namespace rhexis::lua
