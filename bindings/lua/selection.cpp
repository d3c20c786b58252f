// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/selection.hpp"

#include <lauxlib.h>

#include <algorithm>

#include "lua/stack.hpp"

namespace rhexis::lua {
namespace {

std::vector<int> select_by_function(lua_State* L, int function, const std::vector<Vec3>& points) {
    std::vector<int> chosen;
    for (std::size_t k = 0; k < points.size(); ++k) {
        lua_pushvalue(L, function);
        push(L, points[k].x());
        push(L, points[k].y());
        push(L, points[k].z());
        lua_call(L, 3, 1);
        if (lua_toboolean(L, -1) != 0) {
            chosen.push_back(static_cast<int>(k));
        }
        lua_pop(L, 1);
    }
    return chosen;
}

std::vector<int> select_by_box(lua_State* L, int table, const std::vector<Vec3>& points, const std::string& what) {
    constexpr double far = 1e9;  // [mm]; a side left out does not bound
    Options options(L, table, what);
    const Vec3 low = options.vec3("low", Vec3::Constant(-far));
    const Vec3 high = options.vec3("high", Vec3::Constant(far));
    options.finish();
    std::vector<int> chosen;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const bool inside = (points[k].array() >= low.array()).all() && (points[k].array() <= high.array()).all();
        if (inside) {
            chosen.push_back(static_cast<int>(k));
        }
    }
    return chosen;
}

std::vector<int> select_by_list(lua_State* L, int table, std::size_t count, const std::string& what) {
    std::vector<int> chosen;
    const lua_Integer size = luaL_len(L, table);
    for (lua_Integer k = 1; k <= size; ++k) {
        lua_geti(L, table, k);
        const lua_Integer number = lua_tointeger(L, -1);
        if (lua_isinteger(L, -1) == 0 || number < 1 || number > static_cast<lua_Integer>(count)) {
            raise(L, what + ": entry " + std::to_string(k) + " = " + describe(L, -1) +
                         ": allowed: whole numbers from 1 to " + std::to_string(count));
        }
        chosen.push_back(static_cast<int>(number - 1));
        lua_pop(L, 1);
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

}  // namespace

std::vector<int> read_selection(lua_State* L, int index, const std::vector<Vec3>& points, const std::string& what) {
    index = lua_absindex(L, index);
    if (lua_isnoneornil(L, index)) {
        return {};
    }
    if (lua_isfunction(L, index)) {
        return select_by_function(L, index, points);
    }
    if (!lua_istable(L, index)) {
        raise(L, what + ": expected a function(x, y, z), a box {low = ..., high = ...} or a list of numbers, got " +
                     describe(L, index));
    }
    const bool is_list = lua_geti(L, index, 1) != LUA_TNIL;
    lua_pushnil(L);
    const bool is_empty = lua_next(L, index) == 0;
    lua_settop(L, lua_gettop(L) - (is_empty ? 1 : 3));
    return is_list || is_empty ? select_by_list(L, index, points.size(), what) : select_by_box(L, index, points, what);
}

std::vector<int> read_some(lua_State* L, int index, const std::vector<Vec3>& points, const std::string& what) {
    const bool given = !lua_isnoneornil(L, index);
    std::vector<int> chosen = read_selection(L, index, points, what);
    if (given && chosen.empty()) {
        raise(L, what + ": no node was selected");
    }
    return chosen;
}

void push_numbers(lua_State* L, const std::vector<int>& indices) {
    lua_createtable(L, static_cast<int>(indices.size()), 0);
    for (std::size_t k = 0; k < indices.size(); ++k) {
        lua_pushinteger(L, indices[k] + 1);
        lua_rawseti(L, -2, static_cast<lua_Integer>(k + 1));
    }
}

int check_number_of(lua_State* L, int index, std::size_t count) {
    return static_cast<int>(check_integer(L, index, 1, static_cast<long long>(count))) - 1;
}

}  // namespace rhexis::lua
