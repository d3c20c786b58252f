// SPDX-License-Identifier: GPL-3.0-or-later
// Table functions whose stock versions loop inside C over a length that a script chooses: each call first takes its
// work from the budget, then runs the stock one.
#include <lauxlib.h>

#include <algorithm>

#include "lua/context.hpp"
#include "lua/guard.hpp"
#include "lua/sandbox.hpp"

namespace rhexis::lua {
namespace {

// In the frame of the wrapper, so that its error messages name the function and the script's line.
int call_stock(lua_State* L) { return lua_tocfunction(L, lua_upvalueindex(1))(L); }

// Elements from first to last, charged; absurd counts end the budget or, without one, raise.
void charge_range(lua_State* L, lua_Integer first, lua_Integer last) {
    if (last < first) {
        return;
    }
    const auto count = static_cast<lua_Unsigned>(last) - static_cast<lua_Unsigned>(first);
    if (count > (lua_Unsigned{1} << 40)) {
        luaL_error(L, "too many elements");
    }
    charge(L, static_cast<long long>(count) + 1);
}

int move(lua_State* L) {
    charge_range(L, luaL_checkinteger(L, 2), luaL_checkinteger(L, 3));
    return call_stock(L);
}

int concat(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    const lua_Integer last = lua_isnoneornil(L, 4) ? luaL_len(L, 1) : luaL_checkinteger(L, 4);
    charge_range(L, luaL_optinteger(L, 3, 1), last);
    return call_stock(L);
}

int insert(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    if (lua_gettop(L) > 2) {
        charge_range(L, luaL_checkinteger(L, 2), luaL_len(L, 1));
    }
    return call_stock(L);
}

int remove(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    if (lua_gettop(L) > 1) {
        charge_range(L, luaL_checkinteger(L, 2), luaL_len(L, 1));
    }
    return call_stock(L);
}

void wrap(lua_State* L, const char* name, lua_CFunction function) {
    lua_getfield(L, -1, name);
    lua_pushcclosure(L, function, 1);
    lua_setfield(L, -2, name);
}

}  // namespace

void open_tables(lua_State* L) {
    lua_getglobal(L, "table");
    wrap(L, "move", guarded<move>);
    wrap(L, "concat", guarded<concat>);
    wrap(L, "insert", guarded<insert>);
    wrap(L, "remove", guarded<remove>);
    lua_pop(L, 1);
}

}  // namespace rhexis::lua
