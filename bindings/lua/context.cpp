// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/context.hpp"

#include <cstdlib>

#include "base/clock.hpp"

namespace rhexis::lua {
namespace {

constexpr int quantum = 1000;            // instructions between two looks at the budget
constexpr std::size_t free_bytes = 64;   // bytes allocated per instruction charged
constexpr long long cpu_check_mask = 1;  // look at the clock about every other quantum

std::string expiry_text(lua_State* L) {
    const Context& c = context(L);
    const std::string where = place(L);
    const std::string cause =
        c.remaining < 0
            ? "used up its budget of " + std::to_string(c.options.limits.instructions) + " instructions (endless loop?)"
            : "ran longer than its limit of " + std::to_string(static_cast<long>(c.options.limits.cpu_seconds)) + " s";
    return where + (where.empty() ? "" : ": ") + "stopped: " + cause;
}

// From the first time on, every further instruction raises again, with the first place, so that no pcall can carry on.
[[noreturn]] void expire(lua_State* L, lua_Hook hook) {
    Context& c = context(L);
    if (!c.expired) {
        c.expired_text = expiry_text(L);
        c.expired = true;
    }
    lua_sethook(L, hook, LUA_MASKCOUNT, 1);
    lua_pushlstring(L, c.expired_text.data(), c.expired_text.size());
    lua_error(L);
    std::abort();  // unreachable: lua_error throws
}

// The clock is only a backstop for work inside single instructions (comparing huge strings): whoever stays within
// the instruction budget by ordinary work never reaches it, so results do not depend on time.
bool out_of_time(const Context& c) {
    return ((c.remaining / quantum) & cpu_check_mask) == 0 &&
           thread_cpu_seconds() - c.cpu_start > c.options.limits.cpu_seconds;
}

void count_hook(lua_State* L, lua_Debug*) {
    Context& c = context(L);
    if (!c.armed) {
        return;
    }
    c.remaining -= quantum;
    if (c.expired || c.remaining < 0 || out_of_time(c)) {
        expire(L, count_hook);
    }
}

void spend_on_memory(Context& c, std::size_t bytes) {
    if (!c.armed || c.expired) {
        return;
    }
    c.remaining -= static_cast<long long>(bytes / free_bytes);
    if (c.remaining < 0 && c.current != nullptr) {
        lua_sethook(c.current, count_hook, LUA_MASKCOUNT, 1);  // an allocator must not raise: the next instruction does
    }
}

}  // namespace

Context& context(lua_State* L) { return **static_cast<Context**>(lua_getextraspace(L)); }

void charge(lua_State* L, long long instructions) {
    Context& c = context(L);
    if (!c.armed) {
        return;
    }
    c.remaining -= instructions;
    if (c.remaining < 0) {
        expire(L, count_hook);
    }
}

void raise_if_expired(lua_State* L) {
    const Context& c = context(L);
    if (c.armed && c.expired) {
        expire(L, count_hook);
    }
}

std::string place(lua_State* L) {
    lua_Debug info{};
    for (int level = 0; lua_getstack(L, level, &info) != 0; ++level) {
        lua_getinfo(L, "Sl", &info);
        if (info.currentline > 0) {
            return std::string(info.short_src) + ":" + std::to_string(info.currentline);
        }
    }
    return {};
}

void* allocate(void* user, void* block, std::size_t old_size, std::size_t new_size) {
    Context& c = *static_cast<Context*>(user);
    if (block == nullptr) {
        old_size = 0;  // Lua passes the kind of object here
    }
    if (new_size == 0) {
        std::free(block);
        c.used_bytes -= old_size;
        return nullptr;
    }
    if (new_size > old_size) {
        const std::size_t limit = c.options.limits.memory_bytes;
        const std::size_t more = new_size - old_size;
        if (limit != 0 && (more > limit || c.used_bytes > limit - more)) {
            // While an error unwinds, Lua asks again without a frame to name, or for the engine that passes it on.
            std::string where = c.current != nullptr ? place(c.current) : std::string();
            if (!where.empty() && (c.refused_at.empty() || !where.starts_with("scripts/"))) {
                c.refused_at = std::move(where);
            }
            return nullptr;
        }
        spend_on_memory(c, more);
    }
    void* moved = std::realloc(block, new_size);
    if (moved != nullptr) {
        c.used_bytes += new_size - old_size;
    }
    return moved;
}

void arm(Context& c) {
    c.expired = false;
    c.refused_at.clear();
    c.remaining = c.options.limits.instructions;
    c.cpu_start = thread_cpu_seconds();
    c.armed = c.remaining > 0;
    if (c.armed) {
        lua_sethook(c.main, count_hook, LUA_MASKCOUNT, quantum);
    }
}

void disarm(Context& c) {
    c.armed = false;
    lua_sethook(c.main, nullptr, 0, 0);
}

}  // namespace rhexis::lua
