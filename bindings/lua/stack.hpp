// SPDX-License-Identifier: GPL-3.0-or-later
// Values to and from the Lua stack, and tables of named options with ranges. Everything here is called inside
// LuaState::run or a guarded function and raises Lua errors that name the function and the argument.
#pragma once

#include <lauxlib.h>
#include <lua.h>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "math/types.hpp"

namespace rhexis::lua {

// ---- push

inline void push(lua_State* L, bool value) { lua_pushboolean(L, value ? 1 : 0); }
inline void push(lua_State* L, int value) { lua_pushinteger(L, value); }
inline void push(lua_State* L, long long value) { lua_pushinteger(L, value); }
inline void push(lua_State* L, double value) { lua_pushnumber(L, value); }
inline void push(lua_State* L, std::string_view value) { lua_pushlstring(L, value.data(), value.size()); }
inline void push(lua_State* L, const char* value) { lua_pushstring(L, value); }
/// As {x, y, z}.
void push(lua_State* L, const Vec3& value);
void push(lua_State* L, const std::vector<std::string>& values);

/// table[name] = value, for the table on top of the stack.
template <typename T>
void set_field(lua_State* L, const char* name, const T& value) {
    push(L, value);
    lua_setfield(L, -2, name);
}

/// Registers a library table of guarded functions on top of the stack.
void push_library(lua_State* L, const std::vector<luaL_Reg>& functions);

// ---- arguments of the function that runs; each raises "bad argument #2 to 'name' (...)"

bool check_bool(lua_State* L, int index);
double check_number(lua_State* L, int index);  ///< finite
long long check_integer(lua_State* L, int index, long long low, long long high);
std::string check_string(lua_State* L, int index);
Vec3 check_vec3(lua_State* L, int index);  ///< {x, y, z}, all finite

// ---- tables of options

struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    const char* unit = "";
    bool low_excluded = false;
};

/// Reads named fields of the table at `index` (nil counts as an empty table). Every field has a default; a value out of
/// its range, of another type, or a field that is not known raises one line with field, value, what is allowed. Where
/// the registry holds a table "rhexis.options", it receives of each field {default =, allowed =}: what the stubs say is
/// compared with that.
///
///   Options options(L, 2, "scene.plane");
///   plane.friction = options.number("friction", 0.3, {0.0, 2.0});
///   options.finish();   // unknown fields: "did you mean friction?"
class Options {
public:
    Options(lua_State* L, int index, std::string function);

    [[nodiscard]] bool has(const char* name);
    double number(const char* name, double otherwise, const Range& range);
    long long integer(const char* name, long long otherwise, long long low, long long high);
    bool boolean(const char* name, bool otherwise);
    std::string string(const char* name, const std::string& otherwise);
    /// One of the words.
    std::string choice(const char* name, const std::string& otherwise, const std::vector<std::string>& words);
    Vec3 vec3(const char* name, const Vec3& otherwise);
    std::vector<std::string> strings(const char* name, const std::vector<std::string>& otherwise);
    /// Pushes the field, nil if absent.
    int push_field(const char* name);
    /// The name is known, whatever it holds.
    void allow(const char* name);
    /// Raises on the first (in sorted order) field that was never asked for.
    void finish();

    [[noreturn]] void fail(const char* name, const std::string& problem);

private:
    template <typename T>
    void tell(const char* name, const T& otherwise, const std::string& allowed);

    lua_State* L_;
    int index_;
    std::string function_;
    std::vector<std::string> known_;
};

/// The value at index as an error message shows it: 3.5, "text", true, a table.
std::string describe(lua_State* L, int index);

/// Raises `text` with the script's file:line.
[[noreturn]] void raise(lua_State* L, const std::string& text);

}  // namespace rhexis::lua
