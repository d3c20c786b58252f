// SPDX-License-Identifier: GPL-3.0-or-later
// pairs, next, table.sort, tostring and print that give the same result in every run.
//
// Lua walks a table in the order of hashes, which are seeded from addresses and the clock. Here keys are walked sorted:
// numbers by value, strings by bytes, false before true. `pairs` sorts a copy of the keys once and skips those whose
// value has become nil; a key added during the walk is not visited. `next` looks for the smallest key above the given
// one, so it needs no memory and works whatever was assigned meanwhile. Keys that are tables, functions or userdata
// have no order of their own: a sandboxed script may hold and look them up, but not walk over two of them.
#include <lauxlib.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "lua/context.hpp"
#include "lua/guard.hpp"
#include "lua/sandbox.hpp"

namespace rhexis::lua {
namespace {

struct Key {
    int type = LUA_TNIL;
    bool integral = false;
    lua_Integer integer = 0;   // number keys with an exact integer, and booleans
    lua_Number real = 0.0;     // other number keys
    std::string_view text;     // string keys: owned by the table while it holds the key
    lua_Integer position = 0;  // in the walk that found it
};

int rank(int type) {
    switch (type) {
        case LUA_TNUMBER:
            return 0;
        case LUA_TSTRING:
            return 1;
        case LUA_TBOOLEAN:
            return 2;
        default:
            return 3;
    }
}

bool has_order(const Key& key) { return rank(key.type) < 3; }

bool number_less(const Key& a, const Key& b) {
    if (a.integral && b.integral) {
        return a.integer < b.integer;
    }
    // x86's long double holds every integer and every double exactly.
    const long double left = a.integral ? static_cast<long double>(a.integer) : static_cast<long double>(a.real);
    const long double right = b.integral ? static_cast<long double>(b.integer) : static_cast<long double>(b.real);
    return left < right;
}

bool less(const Key& a, const Key& b) {
    if (rank(a.type) != rank(b.type)) {
        return rank(a.type) < rank(b.type);
    }
    switch (a.type) {
        case LUA_TNUMBER:
            return number_less(a, b);
        case LUA_TSTRING:
            return a.text < b.text;
        case LUA_TBOOLEAN:
            return a.integer < b.integer;
        default:
            return a.position < b.position;
    }
}

Key read_key(lua_State* L, int index) {
    Key key;
    key.type = lua_type(L, index);
    if (key.type == LUA_TNUMBER) {
        key.integral = lua_isinteger(L, index) != 0;
        key.integer = key.integral ? lua_tointeger(L, index) : 0;
        key.real = key.integral ? 0.0 : lua_tonumber(L, index);
    } else if (key.type == LUA_TSTRING) {
        std::size_t size = 0;
        const char* text = lua_tolstring(L, index, &size);
        key.text = {text, size};
    } else if (key.type == LUA_TBOOLEAN) {
        key.integer = lua_toboolean(L, index);
    }
    return key;
}

[[noreturn]] void raise_unordered(lua_State* L, int type) {
    luaL_error(L,
               "this table has several keys of type %s, and their order would differ from run to run: use names or "
               "numbers as keys where a table is walked",
               lua_typename(L, type));
    std::abort();  // unreachable: luaL_error throws
}

// A user's own script may walk object keys, after all others, in Lua's order.
bool strict(lua_State* L) { return context(L).options.kind == LuaKind::sandbox; }

// The keys of the table at index 1 into the Lua list at index 2, in the order of the stock `next`.
std::vector<Key> collect_keys(lua_State* L) {
    std::vector<Key> keys;
    int objects = 0;
    lua_pushnil(L);
    while (lua_next(L, 1) != 0) {
        lua_pop(L, 1);
        keys.push_back(read_key(L, -1));
        keys.back().position = static_cast<lua_Integer>(keys.size());
        objects += has_order(keys.back()) ? 0 : 1;
        if (objects > 1 && strict(L)) {
            raise_unordered(L, keys.back().type);
        }
        lua_pushvalue(L, -1);
        lua_rawseti(L, 2, keys.back().position);
    }
    charge(L, static_cast<long long>(keys.size()));
    return keys;
}

// Pushes a list of the keys of the table at index 1, sorted.
void push_sorted_keys(lua_State* L) {
    lua_newtable(L);
    std::vector<Key> keys = collect_keys(L);
    if (std::is_sorted(keys.begin(), keys.end(), less)) {
        return;
    }
    std::stable_sort(keys.begin(), keys.end(), less);
    lua_createtable(L, static_cast<int>(std::min<std::size_t>(keys.size(), 1U << 24)), 0);
    for (std::size_t k = 0; k < keys.size(); ++k) {
        lua_rawgeti(L, 2, keys[k].position);
        lua_rawseti(L, 3, static_cast<lua_Integer>(k + 1));
    }
    lua_replace(L, 2);
}

// Upvalues: table, its sorted keys, how far the walk is.
int walk(lua_State* L) {
    lua_settop(L, 0);
    for (lua_Integer at = lua_tointeger(L, lua_upvalueindex(3)) + 1;; ++at) {
        const int type = lua_rawgeti(L, lua_upvalueindex(2), at);
        if (type == LUA_TNIL) {
            return 1;
        }
        lua_pushvalue(L, -1);
        if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) {
            lua_pushinteger(L, at);
            lua_copy(L, -1, lua_upvalueindex(3));
            lua_pop(L, 1);
            return 2;
        }
        lua_settop(L, 0);  // assigned nil since the walk began
    }
}

int pairs(lua_State* L) {
    luaL_checkany(L, 1);
    lua_settop(L, 1);
    if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
        lua_pushvalue(L, 1);
        lua_call(L, 1, 3);
        return 3;
    }
    luaL_checktype(L, 1, LUA_TTABLE);
    push_sorted_keys(L);
    lua_pushvalue(L, 1);
    lua_insert(L, 2);  // table, table, keys
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, guarded<walk>, 3);
    lua_insert(L, 1);  // walk, table
    lua_pushnil(L);
    return 3;
}

// The smallest key above `after` (or of all), left on the stack; false if there is none.
bool push_next_key(lua_State* L, bool bounded) {
    const Key after = bounded ? read_key(L, 2) : Key{};
    Key best;
    long long count = 0;
    int objects = 0;
    lua_settop(L, 2);
    lua_pushnil(L);  // index 3: the best key so far
    lua_pushnil(L);
    while (lua_next(L, 1) != 0) {
        lua_pop(L, 1);
        const Key key = read_key(L, -1);
        ++count;
        objects += has_order(key) ? 0 : 1;
        if ((!bounded || less(after, key)) && (best.type == LUA_TNIL || less(key, best))) {
            best = key;
            lua_pushvalue(L, -1);
            lua_replace(L, 3);
        }
    }
    charge(L, count);
    if (objects > 1 && best.type != LUA_TNIL && !has_order(best)) {
        raise_unordered(L, best.type);
    }
    return best.type != LUA_TNIL;
}

int ordered_next(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    lua_settop(L, 2);
    const bool bounded = !lua_isnil(L, 2);
    if (bounded && rank(lua_type(L, 2)) == 3) {  // the one object key comes last
        lua_pushnil(L);
        return 1;
    }
    if (!push_next_key(L, bounded)) {
        lua_pushnil(L);
        return 1;
    }
    lua_settop(L, 3);
    lua_pushvalue(L, 3);
    lua_rawget(L, 1);
    return 2;
}

// Is the value at index a to come before the one at b? The comparator, if any, is at index 2.
bool comes_before(lua_State* L, int a, int b) {
    if (lua_isnil(L, 2)) {
        return lua_compare(L, a, b, LUA_OPLT) != 0;
    }
    lua_pushvalue(L, 2);
    lua_pushvalue(L, a);
    lua_pushvalue(L, b);
    lua_call(L, 2, 1);
    const bool before = lua_toboolean(L, -1) != 0;
    lua_pop(L, 1);
    return before;
}

// Merges the sorted runs [low, middle) and [middle, high) of the list at `from` into the list at `into`.
void merge(lua_State* L, int from, int into, lua_Integer low, lua_Integer middle, lua_Integer high) {
    lua_Integer left = low;
    lua_Integer right = middle;
    for (lua_Integer out = low; out < high; ++out) {
        bool take_right = left >= middle;
        if (!take_right && right < high) {
            lua_rawgeti(L, from, left);
            lua_rawgeti(L, from, right);
            take_right = comes_before(L, lua_gettop(L), lua_gettop(L) - 1);
            lua_pop(L, 2);
        }
        lua_rawgeti(L, from, take_right ? right++ : left++);
        lua_rawseti(L, into, out);
    }
}

// Merge sort, bottom up: stable, and asks the comparator in an order that depends on the values alone.
int sort(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    if (!lua_isnoneornil(L, 2)) {
        luaL_checktype(L, 2, LUA_TFUNCTION);
    }
    lua_settop(L, 2);
    const lua_Integer count = luaL_len(L, 1);
    luaL_argcheck(L, count < (lua_Integer{1} << 24), 1, "list too long to sort");
    lua_createtable(L, static_cast<int>(std::max<lua_Integer>(count, 0)), 0);  // index 3
    lua_createtable(L, static_cast<int>(std::max<lua_Integer>(count, 0)), 0);  // index 4
    for (lua_Integer k = 1; k <= count; ++k) {
        lua_geti(L, 1, k);
        lua_rawseti(L, 3, k);
    }
    int from = 3;
    for (lua_Integer width = 1; width < count; width *= 2) {
        charge(L, count);
        for (lua_Integer low = 1; low <= count; low += 2 * width) {
            const lua_Integer middle = std::min(low + width, count + 1);
            merge(L, from, 7 - from, low, middle, std::min(low + 2 * width, count + 1));
        }
        from = 7 - from;
    }
    for (lua_Integer k = 1; k <= count; ++k) {
        lua_rawgeti(L, from, k);
        lua_seti(L, 1, k);
    }
    return 0;
}

int to_string(lua_State* L) {
    luaL_checkany(L, 1);
    push_text(L, 1);
    return 1;
}

int print(lua_State* L) {
    const int count = lua_gettop(L);
    std::string line;
    for (int k = 1; k <= count; ++k) {
        push_text(L, k);
        line += (k > 1 ? "\t" : "");
        line += lua_tostring(L, -1);
        lua_pop(L, 1);
    }
    charge(L, 100 + static_cast<long long>(line.size()));
    if (const auto& sink = context(L).options.print) {
        sink(line);
    }
    return 0;
}

}  // namespace

void push_text(lua_State* L, int index) {
    index = lua_absindex(L, index);
    if (luaL_callmeta(L, index, "__tostring") != 0) {
        if (lua_isstring(L, -1) == 0) {
            luaL_error(L, "'__tostring' must return a string");
        }
        return;
    }
    switch (lua_type(L, index)) {
        case LUA_TNIL:
        case LUA_TBOOLEAN:
        case LUA_TNUMBER:
        case LUA_TSTRING:
            luaL_tolstring(L, index, nullptr);
            return;
        default:
            break;
    }
    if (luaL_getmetafield(L, index, "__name") == LUA_TSTRING) {
        return;
    }
    lua_pushstring(L, luaL_typename(L, index));
}

void open_order(lua_State* L) {
    lua_register(L, "pairs", guarded<pairs>);
    lua_register(L, "next", guarded<ordered_next>);
    lua_register(L, "tostring", guarded<to_string>);
    lua_register(L, "print", guarded<print>);
    lua_getglobal(L, "table");
    lua_pushcfunction(L, guarded<sort>);
    lua_setfield(L, -2, "sort");
    lua_pop(L, 1);
}

}  // namespace rhexis::lua
