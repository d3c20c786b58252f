// SPDX-License-Identifier: GPL-3.0-or-later
// math.random from the state's own stream, so that a seed fixes what a script draws.
#include "lua/context.hpp"
#include "lua/guard.hpp"
#include "lua/sandbox.hpp"

namespace rhexis::lua {
namespace {

int random(lua_State* L) {
    Rng& rng = context(L).rng;
    const int count = lua_gettop(L);
    if (count == 0) {
        lua_pushnumber(L, rng.uniform());
        return 1;
    }
    const lua_Integer low = count == 1 ? 1 : luaL_checkinteger(L, 1);
    const lua_Integer high = luaL_checkinteger(L, count == 1 ? 1 : 2);
    luaL_argcheck(L, count <= 2, 3, "at most two arguments");
    luaL_argcheck(L, low <= high, count == 1 ? 1 : 2, "interval is empty");
    lua_pushinteger(L, rng.integer(low, high));
    return 1;
}

int randomseed(lua_State* L) {
    Context& c = context(L);
    const bool given = lua_gettop(L) > 0;
    const lua_Number number = given ? luaL_checknumber(L, 1) : 0.0;
    luaL_argcheck(L, number >= -9.0e15 && number <= 9.0e15, 1, "seed must lie between -9e15 and 9e15");
    c.rng = Rng(given ? static_cast<std::uint64_t>(static_cast<std::int64_t>(number)) : c.options.seed, "lua");
    return 0;
}

}  // namespace

void open_random(lua_State* L) {
    lua_getglobal(L, "math");
    lua_pushcfunction(L, guarded<random>);
    lua_setfield(L, -2, "random");
    lua_pushcfunction(L, guarded<randomseed>);
    lua_setfield(L, -2, "randomseed");
    lua_pop(L, 1);
}

}  // namespace rhexis::lua
