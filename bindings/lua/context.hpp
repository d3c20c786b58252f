// SPDX-License-Identifier: GPL-3.0-or-later
// What one Lua state owns beside its values: budget, memory, chance, output. Found again from any lua_State.
#pragma once

#include <lauxlib.h>
#include <lua.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/rng.hpp"

namespace rhexis {

/// Which libraries a script finds.
enum class LuaKind {
    sandbox,  ///< exercises and virtual surgeons: no files, no clock, no native code, same order in every run
    script,   ///< a user's own script: all standard libraries
};

struct LuaLimits {
    std::size_t memory_bytes = std::size_t{64} << 20;  ///< 0: no limit
    long long instructions = 20'000'000;               ///< per LuaState::run, VM instructions; 0: no limit
    double cpu_seconds = 20.0;                         ///< backstop per LuaState::run for work the count cannot see [s]
};

/// A folder that `require` searches. Scripts in it are named `label/relative path` in messages.
struct ScriptFolder {
    std::string path;
    std::string label;
};

struct LuaOptions {
    LuaKind kind = LuaKind::sandbox;
    LuaLimits limits;
    std::uint64_t seed = 1;                       ///< of math.random
    std::function<void(std::string_view)> print;  ///< receives each printed line without its newline; empty: dropped
    std::vector<ScriptFolder> folders;            ///< searched by `require`, in this order
};

namespace lua {

struct Objects;

struct Context {
    LuaOptions options;
    Rng rng;
    lua_State* main = nullptr;
    lua_State* current = nullptr;  ///< the coroutine that runs now
    int depth = 0;                 ///< nested LuaState::run
    std::size_t used_bytes = 0;
    bool armed = false;    ///< a budget is counting
    bool expired = false;  ///< it ran out: every further instruction raises
    long long remaining = 0;
    double cpu_start = 0.0;
    std::string expired_text;  ///< where and why it ran out
    std::string refused_at;  ///< file:line of the last allocation that was refused; of the engine only if it was first
    std::string traceback;   ///< of the last error
    std::shared_ptr<Objects> objects;  ///< behind the handles of the kernel modules, if they are open

    explicit Context(LuaOptions given) : options(std::move(given)), rng(options.seed, "lua") {}
};

Context& context(lua_State* L);

/// Takes the cost of work done in C++ from the budget, in VM instructions; raises when it runs out.
void charge(lua_State* L, long long instructions);

/// Raises if the budget ran out earlier: called where a script could otherwise swallow that error.
void raise_if_expired(lua_State* L);

/// "file:line" of the innermost Lua function that runs, or empty.
std::string place(lua_State* L);

/// Allocator with the context as user data: enforces the memory limit.
void* allocate(void* user, void* block, std::size_t old_size, std::size_t new_size);

/// Starts counting for one LuaState::run.
void arm(Context& context);
void disarm(Context& context);

}  // namespace lua
}  // namespace rhexis
