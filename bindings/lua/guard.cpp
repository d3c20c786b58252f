// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/guard.hpp"

#include <exception>

#include "lua/context.hpp"

namespace rhexis::lua {

int run_guarded(lua_State* L, lua_CFunction function) {
    try {
        return function(L);
    } catch (const std::exception& error) {
        luaL_where(L, 1);
        lua_pushstring(L, error.what());
        lua_concat(L, 2);
    }
    return lua_error(L);  // outside the handler: the caught exception is gone by now
}

}  // namespace rhexis::lua
