// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/sandbox.hpp"

#include <lauxlib.h>
#include <lualib.h>

#include <array>

#include "lua/context.hpp"

namespace rhexis::lua {
namespace {

void open(lua_State* L, const char* name, lua_CFunction opener) {
    luaL_requiref(L, name, opener, 1);
    lua_pop(L, 1);
}

void remove_globals(lua_State* L) {
    for (const char* name : {"load", "loadfile", "dofile", "collectgarbage", "warn"}) {
        lua_pushnil(L);
        lua_setglobal(L, name);
    }
    lua_getglobal(L, "string");
    lua_pushnil(L);
    lua_setfield(L, -2, "dump");
    lua_pop(L, 1);
}

// getmetatable("") would otherwise hand out the table that every string in the state shares.
void lock_string_metatable(lua_State* L) {
    lua_pushliteral(L, "");
    lua_getmetatable(L, -1);
    lua_pushliteral(L, "locked");
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 2);
}

void open_sandbox(lua_State* L) {
    open(L, LUA_GNAME, luaopen_base);
    open(L, LUA_TABLIBNAME, luaopen_table);
    open(L, LUA_STRLIBNAME, luaopen_string);
    open(L, LUA_MATHLIBNAME, luaopen_math);
    open(L, LUA_UTF8LIBNAME, luaopen_utf8);
    open(L, LUA_COLIBNAME, luaopen_coroutine);
    remove_globals(L);
    open_strings(L);
    open_tables(L);
    open_protection(L);
    open_require(L);
    lock_string_metatable(L);
}

}  // namespace

void open_libraries(lua_State* L) {
    if (context(L).options.kind == LuaKind::sandbox) {
        open_sandbox(L);
    } else {
        luaL_openlibs(L);
    }
    open_order(L);
    open_random(L);
}

}  // namespace rhexis::lua
