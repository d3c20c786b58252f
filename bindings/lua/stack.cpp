// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/stack.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/near_names.hpp"
#include "lua/sandbox.hpp"

namespace rhexis::lua {
namespace {

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string allowed(const Range& range) {
    const std::string unit = *range.unit == '\0' ? "" : std::string(" ") + range.unit;
    const bool low = std::isfinite(range.low);
    const bool high = std::isfinite(range.high);
    if (low && high) {
        return (range.low_excluded ? "above " : "") + short_number(range.low) +
               (range.low_excluded ? " up to " : " to ") + short_number(range.high) + unit;
    }
    if (low) {
        return (range.low_excluded ? "above " : "at least ") + short_number(range.low) + unit;
    }
    return high ? "at most " + short_number(range.high) + unit : "a finite number" + unit;
}

bool inside(const Range& range, double value) {
    return std::isfinite(value) && (range.low_excluded ? value > range.low : value >= range.low) && value <= range.high;
}

// x, y, z of the table at index, or false.
bool read_vec3(lua_State* L, int index, Vec3& value) {
    index = lua_absindex(L, index);
    if (!lua_istable(L, index) || luaL_len(L, index) != 3) {
        return false;
    }
    bool good = true;
    for (int k = 0; k < 3; ++k) {
        good = lua_geti(L, index, k + 1) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, -1)) && good;
        value[k] = lua_tonumber(L, -1);
        lua_pop(L, 1);
    }
    return good;
}

}  // namespace

void raise(lua_State* L, const std::string& text) {
    luaL_where(L, 1);
    push(L, text);
    lua_concat(L, 2);
    lua_error(L);
    std::abort();  // unreachable: lua_error throws
}

void push(lua_State* L, const Vec3& value) {
    lua_createtable(L, 3, 0);
    for (int k = 0; k < 3; ++k) {
        lua_pushnumber(L, value[k]);
        lua_rawseti(L, -2, k + 1);
    }
}

void push(lua_State* L, const std::vector<std::string>& values) {
    lua_createtable(L, static_cast<int>(values.size()), 0);
    for (std::size_t k = 0; k < values.size(); ++k) {
        push(L, std::string_view(values[k]));
        lua_rawseti(L, -2, static_cast<lua_Integer>(k + 1));
    }
}

void push_library(lua_State* L, const std::vector<luaL_Reg>& functions) {
    lua_createtable(L, 0, static_cast<int>(functions.size()));
    for (const luaL_Reg& function : functions) {
        lua_pushcfunction(L, function.func);
        lua_setfield(L, -2, function.name);
    }
}

bool check_bool(lua_State* L, int index) {
    luaL_checktype(L, index, LUA_TBOOLEAN);
    return lua_toboolean(L, index) != 0;
}

double check_number(lua_State* L, int index) {
    const double value = luaL_checknumber(L, index);
    luaL_argcheck(L, std::isfinite(value), index, "not a finite number");
    return value;
}

long long check_integer(lua_State* L, int index, long long low, long long high) {
    const long long value = luaL_checkinteger(L, index);
    if (value < low || value > high) {
        luaL_argerror(L, index, lua_pushfstring(L, "%I is out of range: %I to %I", value, low, high));
    }
    return value;
}

std::string check_string(lua_State* L, int index) {
    std::size_t size = 0;
    const char* text = luaL_checklstring(L, index, &size);
    return {text, size};
}

Vec3 check_vec3(lua_State* L, int index) {
    Vec3 value = Vec3::Zero();
    luaL_argcheck(L, read_vec3(L, index, value), index, "expected three finite numbers {x, y, z}");
    return value;
}

std::string describe(lua_State* L, int index) {
    std::string text;
    switch (lua_type(L, index)) {
        case LUA_TNUMBER:
            text = short_number(lua_tonumber(L, index));
            break;
        case LUA_TBOOLEAN:
            text = lua_toboolean(L, index) != 0 ? "true" : "false";
            break;
        case LUA_TSTRING:
            text.append("\"").append(std::string_view(lua_tostring(L, index)).substr(0, 60)).append("\"");
            break;
        case LUA_TNIL:
            text = "nil";
            break;
        default:
            text.append("a ").append(luaL_typename(L, index));
    }
    return text;
}

// ---- Options

Options::Options(lua_State* L, int index, std::string function)
    : L_(L), index_(lua_absindex(L, index)), function_(std::move(function)) {
    if (!lua_isnoneornil(L, index_) && !lua_istable(L, index_)) {
        raise(L, function_ + ": expected a table of options, got " + describe(L, index_));
    }
}

template <typename T>
void Options::tell(const char* name, const T& otherwise, const std::string& allowed) {
    if (lua_getfield(L_, LUA_REGISTRYINDEX, "rhexis.options") == LUA_TTABLE) {
        lua_createtable(L_, 0, 2);
        set_field(L_, "default", otherwise);
        set_field(L_, "allowed", allowed);
        lua_setfield(L_, -2, name);
    }
    lua_pop(L_, 1);
}

void Options::allow(const char* name) { known_.emplace_back(name); }

int Options::push_field(const char* name) {
    allow(name);
    if (!lua_istable(L_, index_)) {
        lua_pushnil(L_);
        return LUA_TNIL;
    }
    return lua_getfield(L_, index_, name);
}

bool Options::has(const char* name) {
    const bool present = push_field(name) != LUA_TNIL;
    lua_pop(L_, 1);
    return present;
}

void Options::fail(const char* name, const std::string& problem) {
    raise(L_, function_ + ": " + name + " = " + describe(L_, -1) + ": " + problem);
}

double Options::number(const char* name, double otherwise, const Range& range) {
    tell(name, otherwise, allowed(range));
    const int type = push_field(name);
    if (type == LUA_TNIL) {
        lua_pop(L_, 1);
        return otherwise;
    }
    const double value = lua_tonumber(L_, -1);
    if (type != LUA_TNUMBER || !inside(range, value)) {
        fail(name, "allowed: " + allowed(range));
    }
    lua_pop(L_, 1);
    return value;
}

long long Options::integer(const char* name, long long otherwise, long long low, long long high) {
    const double value =
        number(name, static_cast<double>(otherwise), {static_cast<double>(low), static_cast<double>(high)});
    if (value != std::floor(value)) {
        lua_pushnumber(L_, value);
        fail(name, "allowed: a whole number");
    }
    return static_cast<long long>(value);
}

bool Options::boolean(const char* name, bool otherwise) {
    tell(name, otherwise, "");
    const int type = push_field(name);
    if (type != LUA_TNIL && type != LUA_TBOOLEAN) {
        fail(name, "allowed: true or false");
    }
    const bool value = type == LUA_TNIL ? otherwise : lua_toboolean(L_, -1) != 0;
    lua_pop(L_, 1);
    return value;
}

std::string Options::string(const char* name, const std::string& otherwise) {
    tell(name, otherwise, "");
    const int type = push_field(name);
    if (type != LUA_TNIL && type != LUA_TSTRING) {
        fail(name, "allowed: a text");
    }
    std::string value = type == LUA_TNIL ? otherwise : lua_tostring(L_, -1);
    lua_pop(L_, 1);
    return value;
}

std::string Options::choice(const char* name, const std::string& otherwise, const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) {
        list += (list.empty() ? "" : ", ") + word;
    }
    std::string value = string(name, otherwise);
    tell(name, otherwise, list);
    if (std::find(words.begin(), words.end(), value) == words.end()) {
        push(L_, value);
        fail(name, "allowed: " + list);
    }
    return value;
}

Vec3 Options::vec3(const char* name, const Vec3& otherwise) {
    Vec3 value = otherwise;
    tell(name, otherwise, "");
    if (push_field(name) != LUA_TNIL && !read_vec3(L_, -1, value)) {
        fail(name, "allowed: three finite numbers {x, y, z}");
    }
    lua_pop(L_, 1);
    return value;
}

std::vector<std::string> Options::strings(const char* name, const std::vector<std::string>& otherwise) {
    std::vector<std::string> values;
    tell(name, otherwise, "");
    const int type = push_field(name);
    if (type == LUA_TNIL) {
        lua_pop(L_, 1);
        return otherwise;
    }
    if (type != LUA_TTABLE) {
        fail(name, "allowed: a list of names");
    }
    const lua_Integer count = luaL_len(L_, -1);
    for (lua_Integer k = 1; k <= count; ++k) {
        if (lua_geti(L_, -1, k) != LUA_TSTRING) {
            fail(name, "allowed: a list of names");
        }
        values.emplace_back(lua_tostring(L_, -1));
        lua_pop(L_, 1);
    }
    lua_pop(L_, 1);
    return values;
}

void Options::finish() {
    if (!lua_istable(L_, index_)) {
        return;
    }
    std::vector<std::string> unknown;
    lua_pushnil(L_);
    while (lua_next(L_, index_) != 0) {
        lua_pop(L_, 1);
        const std::string name = lua_type(L_, -1) == LUA_TSTRING ? lua_tostring(L_, -1) : describe(L_, -1);
        if (std::find(known_.begin(), known_.end(), name) == known_.end()) {
            unknown.push_back(name);
        }
    }
    if (!unknown.empty()) {
        const std::string& first = *std::min_element(unknown.begin(), unknown.end());
        raise(L_, function_ + ": unknown field '" + first + "' (" + suggestion(first, known_) + ")");
    }
}

}  // namespace rhexis::lua
