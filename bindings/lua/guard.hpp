// SPDX-License-Identifier: GPL-3.0-or-later
// The one trampoline between Lua and C++: every bound function goes through it, so that no exception of ours crosses
// the interpreter. Lua's own errors are C++ exceptions of another type (Lua is compiled as C++): they pass through and
// run destructors on the way.
#pragma once

#include <lua.h>

namespace rhexis::lua {

/// Calls `function`; a std::exception becomes a Lua error with the script's file:line.
int run_guarded(lua_State* L, lua_CFunction function);

template <lua_CFunction function>
int guarded(lua_State* L) {
    return run_guarded(L, function);
}

}  // namespace rhexis::lua
