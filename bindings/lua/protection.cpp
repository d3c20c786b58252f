// SPDX-License-Identifier: GPL-3.0-or-later
// The functions by which a script could outlive its budget: protected calls, coroutines, metatables.
#include <lauxlib.h>

#include "lua/context.hpp"
#include "lua/guard.hpp"
#include "lua/sandbox.hpp"

namespace rhexis::lua {
namespace {

constexpr long long switch_cost = 200;  // a coroutine's first instructions are not seen by the count

// ---- pcall, xpcall. A call may yield, so both go on in a continuation, which Lua calls directly.

int finish_pcall(lua_State* L, int status, lua_KContext) {
    raise_if_expired(L);
    if (status == LUA_OK || status == LUA_YIELD) {
        return lua_gettop(L);  // true and the results
    }
    lua_pushboolean(L, 0);
    lua_insert(L, -2);
    return 2;
}

int pcall(lua_State* L) {
    luaL_checkany(L, 1);
    lua_pushboolean(L, 1);
    lua_insert(L, 1);
    const int status = lua_pcallk(L, lua_gettop(L) - 2, LUA_MULTRET, 0, 0, finish_pcall);
    return finish_pcall(L, status, 0);
}

// The handler runs after the error has unwound: an error raised by the count hook would run a handler with hooks off,
// and nothing could stop an endless one. Without debug.traceback a script cannot tell the difference.
int finish_xpcall(lua_State* L, int status, lua_KContext) {
    raise_if_expired(L);
    if (status == LUA_OK || status == LUA_YIELD) {
        return lua_gettop(L) - 1;  // true and the results; the handler stays below
    }
    lua_pushvalue(L, 1);
    lua_insert(L, -2);
    lua_call(L, 1, 1);
    lua_pushboolean(L, 0);
    lua_insert(L, -2);
    return 2;
}

int xpcall(lua_State* L) {
    luaL_checkany(L, 1);
    luaL_checktype(L, 2, LUA_TFUNCTION);
    lua_pushvalue(L, 1);
    lua_pushvalue(L, 2);
    lua_replace(L, 1);
    lua_pushboolean(L, 1);
    lua_replace(L, 2);
    lua_insert(L, 3);  // handler, true, function, arguments...
    const int status = lua_pcallk(L, lua_gettop(L) - 3, LUA_MULTRET, 0, 0, finish_xpcall);
    return finish_xpcall(L, status, 0);
}

// ---- coroutines

class RunningThread {
public:
    RunningThread(Context& context, lua_State* thread) : context_(context), outer_(context.current) {
        context_.current = thread;
    }
    ~RunningThread() { context_.current = outer_; }
    RunningThread(const RunningThread&) = delete;
    RunningThread& operator=(const RunningThread&) = delete;

private:
    Context& context_;
    lua_State* outer_;
};

// Arguments on top of L; leaves results there and returns their number, or leaves the error and returns -1.
int resume(lua_State* L, lua_State* thread, int arguments) {
    charge(L, switch_cost);
    if (lua_checkstack(thread, arguments) == 0) {
        lua_pushliteral(L, "too many arguments to resume");
        return -1;
    }
    lua_xmove(L, thread, arguments);
    int results = 0;
    int status = LUA_OK;
    {
        const RunningThread running(context(L), thread);
        // A coroutine made in an earlier, finished run has a hook of that run: give it the one in force.
        lua_sethook(thread, lua_gethook(L), lua_gethookmask(L), lua_gethookcount(L));
        status = lua_resume(thread, L, arguments, &results);
    }
    raise_if_expired(L);
    if (status != LUA_OK && status != LUA_YIELD) {
        lua_xmove(thread, L, 1);
        return -1;
    }
    if (lua_checkstack(L, results + 1) == 0) {
        lua_pop(thread, results);
        lua_pushliteral(L, "too many results to resume");
        return -1;
    }
    lua_xmove(thread, L, results);
    return results;
}

int coroutine_resume(lua_State* L) {
    lua_State* thread = lua_tothread(L, 1);
    luaL_argexpected(L, thread != nullptr, 1, "thread");
    const int results = resume(L, thread, lua_gettop(L) - 1);
    lua_pushboolean(L, results >= 0);
    const int pushed = results >= 0 ? results : 1;
    lua_insert(L, -(pushed + 1));
    return pushed + 1;
}

int wrapped(lua_State* L) {
    lua_State* thread = lua_tothread(L, lua_upvalueindex(1));
    const int results = resume(L, thread, lua_gettop(L));
    if (results >= 0) {
        return results;
    }
    const int status = lua_status(thread);
    if (status != LUA_OK && status != LUA_YIELD) {
        lua_resetthread(thread);  // closes its pending variables
    }
    return lua_error(L);
}

int coroutine_create(lua_State* L) {
    luaL_checktype(L, 1, LUA_TFUNCTION);
    charge(L, switch_cost);
    lua_State* thread = lua_newthread(L);
    lua_pushvalue(L, 1);
    lua_xmove(L, thread, 1);
    return 1;
}

int coroutine_wrap(lua_State* L) {
    coroutine_create(L);
    lua_pushcclosure(L, guarded<wrapped>, 1);
    return 1;
}

// ---- metatables

int setmetatable(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    luaL_argexpected(L, lua_isnil(L, 2) || lua_istable(L, 2), 2, "nil or table");
    lua_settop(L, 2);
    if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL) {
        return luaL_error(L, "cannot change a protected metatable");
    }
    for (const char* field : {"__gc", "__mode"}) {
        lua_pushstring(L, field);
        if (lua_istable(L, 2) && lua_rawget(L, 2) != LUA_TNIL) {
            return luaL_error(L, "setmetatable: the field %s is not available to this script", field);
        }
    }
    lua_settop(L, 2);
    lua_setmetatable(L, 1);
    return 1;
}

void set_functions(lua_State* L, const char* table, const luaL_Reg* functions) {
    lua_getglobal(L, table);
    luaL_setfuncs(L, functions, 0);
    lua_pop(L, 1);
}

}  // namespace

void open_protection(lua_State* L) {
    const luaL_Reg globals[] = {{"pcall", guarded<pcall>},
                                {"xpcall", guarded<xpcall>},
                                {"setmetatable", guarded<setmetatable>},
                                {nullptr, nullptr}};
    const luaL_Reg coroutines[] = {{"create", guarded<coroutine_create>},
                                   {"resume", guarded<coroutine_resume>},
                                   {"wrap", guarded<coroutine_wrap>},
                                   {nullptr, nullptr}};
    set_functions(L, LUA_GNAME, globals);
    set_functions(L, "coroutine", coroutines);
}

}  // namespace rhexis::lua
