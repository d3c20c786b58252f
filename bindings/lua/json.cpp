// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/json.hpp"

#include <lauxlib.h>

#include <cmath>
#include <string>

#include "lua/stack.hpp"

namespace rhexis::lua {
namespace {

constexpr int max_depth = 64;

nlohmann::json convert(lua_State* L, int index, const std::string& path, int depth);

std::string shown(const std::string& path) { return path.empty() ? "the value" : path; }

std::string text_at(lua_State* L, int index) {
    std::size_t size = 0;
    const char* text = lua_tolstring(L, index, &size);
    return {text, size};
}

nlohmann::json convert_number(lua_State* L, int index) {
    if (lua_isinteger(L, index) != 0) {
        return static_cast<std::int64_t>(lua_tointeger(L, index));
    }
    const double value = lua_tonumber(L, index);
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::json convert_array(lua_State* L, int index, const std::string& path, int depth) {
    nlohmann::json array = nlohmann::json::array();
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, index));
    for (lua_Integer k = 1; k <= count; ++k) {
        lua_rawgeti(L, index, k);
        array.push_back(convert(L, -1, path + "[" + std::to_string(k) + "]", depth + 1));
        lua_pop(L, 1);
    }
    return array;
}

// json's own objects are sorted maps: the order of this walk does not show.
nlohmann::json convert_object(lua_State* L, int index, const std::string& path, int depth) {
    nlohmann::json object = nlohmann::json::object();
    lua_pushnil(L);
    while (lua_next(L, index) != 0) {
        if (lua_type(L, -2) != LUA_TSTRING) {
            raise(L, "cannot become JSON: " + shown(path) + " has the key " + describe(L, -2) +
                         " (a list without holes, or names only)");
        }
        const std::string key = text_at(L, -2);
        object[key] = convert(L, -1, path.empty() ? key : path + "." + key, depth + 1);
        lua_pop(L, 1);
    }
    return object;
}

bool marked_object(lua_State* L, int index) {
    if (luaL_getmetafield(L, index, "__json") == LUA_TNIL) {
        return false;
    }
    const bool object = lua_type(L, -1) == LUA_TSTRING && text_at(L, -1) == "object";
    lua_pop(L, 1);
    return object;
}

// Keys exactly 1..n?
bool is_array(lua_State* L, int index) {
    lua_Integer count = 0;
    bool names = false;
    lua_pushnil(L);
    while (lua_next(L, index) != 0) {
        lua_pop(L, 1);
        names = names || lua_isinteger(L, -1) == 0 || lua_tointeger(L, -1) < 1;
        ++count;
    }
    return !names && static_cast<lua_Integer>(lua_rawlen(L, index)) == count;
}

nlohmann::json convert(lua_State* L, int index, const std::string& path, int depth) {
    index = lua_absindex(L, index);
    luaL_checkstack(L, 4, "JSON");
    switch (lua_type(L, index)) {
        case LUA_TNIL:
            return nullptr;
        case LUA_TBOOLEAN:
            return lua_toboolean(L, index) != 0;
        case LUA_TNUMBER:
            return convert_number(L, index);
        case LUA_TSTRING:
            return text_at(L, index);
        case LUA_TTABLE:
            break;
        default:
            raise(L, "cannot become JSON: " + shown(path) + " is " + describe(L, index));
    }
    if (depth > max_depth) {
        raise(L, "cannot become JSON: " + shown(path).substr(0, 60) + "... is nested deeper than 64 (a cycle?)");
    }
    return !marked_object(L, index) && is_array(L, index) ? convert_array(L, index, path, depth)
                                                          : convert_object(L, index, path, depth);
}

}  // namespace

nlohmann::json to_json(lua_State* L, int index) { return convert(L, index, "", 0); }

void push_json(lua_State* L, const nlohmann::json& value) {
    luaL_checkstack(L, 4, "JSON");
    switch (value.type()) {
        case nlohmann::json::value_t::boolean:
            push(L, value.get<bool>());
            return;
        case nlohmann::json::value_t::number_integer:
        case nlohmann::json::value_t::number_unsigned:
            lua_pushinteger(L, value.get<lua_Integer>());
            return;
        case nlohmann::json::value_t::number_float:
            push(L, value.get<double>());
            return;
        case nlohmann::json::value_t::string:
            push(L, std::string_view(value.get_ref<const std::string&>()));
            return;
        case nlohmann::json::value_t::array: {
            lua_createtable(L, static_cast<int>(value.size()), 0);
            lua_Integer k = 0;
            for (const nlohmann::json& item : value) {
                push_json(L, item);
                lua_rawseti(L, -2, ++k);
            }
            return;
        }
        case nlohmann::json::value_t::object:
            lua_createtable(L, 0, static_cast<int>(value.size()));
            for (const auto& [key, item] : value.items()) {
                push(L, std::string_view(key));
                push_json(L, item);
                lua_rawset(L, -3);
            }
            return;
        default:
            lua_pushnil(L);
    }
}

}  // namespace rhexis::lua
