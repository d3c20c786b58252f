// SPDX-License-Identifier: GPL-3.0-or-later
// A Lua 5.4 interpreter that cannot take its host down: capped memory, counted instructions, text-only sources,
// errors as file:line. All work on it happens inside run().
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "lua/context.hpp"

namespace rhexis {

class LuaState {
public:
    /// Opens the libraries of options.kind (bindings/lua/sandbox.hpp).
    static Result<LuaState> create(LuaOptions options);
    ~LuaState();
    LuaState(LuaState&&) noexcept;
    LuaState& operator=(LuaState&&) noexcept;

    /// Runs `body` protected, with a full budget (nested calls share the outer one). The body may raise Lua errors and
    /// throw; its stack is its own, and values it leaves there are dropped. The error has the script's file:line in
    /// `where`. Example:
    ///   Status status = state.run([&](lua_State* L) { on_step.push(L); push(L, 3.0); lua_call(L, 1, 0); });
    Status run(const std::function<void(lua_State*)>& body);

    /// Loads a text file and runs it with string arguments; what it returns is dropped. chunk: its name in messages.
    Status run_file(const std::string& path, const std::string& chunk, const std::vector<std::string>& args = {});
    Status run_text(const std::string& text, const std::string& chunk);

    /// Call stack of the last error, several lines.
    [[nodiscard]] const std::string& traceback() const;
    [[nodiscard]] std::size_t used_bytes() const;
    /// The stream behind math.random, for snapshots.
    [[nodiscard]] Rng& rng();
    /// For use inside run() only.
    [[nodiscard]] lua_State* raw() const;

private:
    friend class LuaRef;
    explicit LuaState(std::shared_ptr<lua::Context> context) : context_(std::move(context)) {}
    std::shared_ptr<lua::Context> context_;
};

/// Keeps a Lua value (a callback, say) alive on the C++ side. May outlive the state; it is then of no use.
class LuaRef {
public:
    LuaRef() = default;
    /// Takes the value on top of the stack and pops it.
    LuaRef(const LuaState& state, lua_State* L);
    ~LuaRef();
    LuaRef(LuaRef&& other) noexcept;
    LuaRef& operator=(LuaRef&& other) noexcept;

    /// Pushes the value, or nil.
    void push(lua_State* L) const;
    [[nodiscard]] bool empty() const { return index_ == LUA_NOREF; }

private:
    void release();
    std::weak_ptr<lua::Context> context_;
    int index_ = LUA_NOREF;
};

namespace lua {

/// Of what a script may have, in bytes.
constexpr std::size_t largest_script = std::size_t{4} << 20;

/// Inside run(): pushes the compiled chunk of a text file of at most largest_script, or raises.
void load_file(lua_State* L, const std::string& path, const std::string& chunk);
void load_text(lua_State* L, const std::string& text, const std::string& chunk);

/// Splits "file:line: message" as Lua writes it into where and what, and several of them, as scripts/engine/words.lua
/// joins them, into the first and the others.
Error error_from_message(const std::string& message);

}  // namespace lua

/// Whether a script is well formed, without running it.
Status check_form_of(const std::string& path, const std::string& chunk);

}  // namespace rhexis
