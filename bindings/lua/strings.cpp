// SPDX-License-Identifier: GPL-3.0-or-later
// string.find, match, gmatch, gsub, rep and format for scripts that must not stop their host: the work of each is taken
// from the instruction budget, and nothing shows an address. Behaviour as in the Lua 5.4 reference manual, section 6.4.
#include <lauxlib.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

#include "lua/context.hpp"
#include "lua/guard.hpp"
#include "lua/pattern.hpp"
#include "lua/sandbox.hpp"

namespace rhexis::lua {
namespace {

constexpr long long unlimited_steps = 50'000'000;  // of one call, where no budget counts

std::string_view check_text(lua_State* L, int index) {
    std::size_t size = 0;
    const char* text = luaL_checklstring(L, index, &size);
    return {text, size};
}

// Matches with what is left of the budget, and takes from it what was used.
std::optional<PatternMatch> match_at(lua_State* L, const Pattern& pattern, std::string_view subject, std::size_t at) {
    const Context& c = context(L);
    const long long available = c.armed ? c.remaining : unlimited_steps;
    long long steps = available;
    std::optional<PatternMatch> match;
    bool exhausted = false;
    try {
        match = pattern.match_at(subject, at, steps);
    } catch (const PatternError&) {
        exhausted = true;
    }
    if (exhausted && !c.armed) {
        luaL_error(L, "pattern takes too many steps on this text");
    }
    charge(L, exhausted ? available + 1 : available - steps);
    return match;
}

std::optional<PatternMatch> search(lua_State* L, const Pattern& pattern, std::string_view subject, std::size_t from) {
    for (std::size_t at = from; at <= subject.size(); ++at) {
        if (std::optional<PatternMatch> match = match_at(L, pattern, subject, at)) {
            return match;
        }
        if (pattern.anchored()) {
            break;
        }
    }
    return std::nullopt;
}

// 0-based start from Lua's 1-based, possibly negative, argument; beyond the end: nullopt.
std::optional<std::size_t> start_of(lua_State* L, int index, std::size_t size) {
    const lua_Integer given = luaL_optinteger(L, index, 1);
    const auto length = static_cast<lua_Integer>(size);
    if (given > length + 1) {
        return std::nullopt;
    }
    if (given > 0) {
        return static_cast<std::size_t>(given - 1);
    }
    return given == 0 || given < -length ? 0 : static_cast<std::size_t>(length + given);
}

void push_capture(lua_State* L, std::string_view subject, const PatternCapture& capture) {
    if (capture.position) {
        lua_pushinteger(L, static_cast<lua_Integer>(capture.begin + 1));
    } else {
        const std::string_view text = subject.substr(capture.begin, capture.end - capture.begin);
        lua_pushlstring(L, text.data(), text.size());
    }
}

// All captures, or the whole match where there are none and it is wanted.
int push_captures(lua_State* L, std::string_view subject, const PatternMatch& match, bool whole_if_none) {
    luaL_checkstack(L, static_cast<int>(match.captures.size()) + 1, "too many captures");
    if (match.captures.empty() && whole_if_none) {
        push_capture(L, subject, {match.begin, match.end, false});
        return 1;
    }
    for (const PatternCapture& capture : match.captures) {
        push_capture(L, subject, capture);
    }
    return static_cast<int>(match.captures.size());
}

int push_plain_find(lua_State* L, std::string_view subject, std::string_view text, std::size_t from) {
    charge(L, static_cast<long long>(subject.size() / 16));
    // memmem is linear in the worst case too.
    const void* found = text.empty() ? subject.data() + from
                                     : memmem(subject.data() + from, subject.size() - from, text.data(), text.size());
    if (found == nullptr) {
        lua_pushnil(L);
        return 1;
    }
    const auto begin = static_cast<lua_Integer>(static_cast<const char*>(found) - subject.data());
    lua_pushinteger(L, begin + 1);
    lua_pushinteger(L, begin + static_cast<lua_Integer>(text.size()));
    return 2;
}

int find_or_match(lua_State* L, bool find) {
    const std::string_view subject = check_text(L, 1);
    const std::string_view text = check_text(L, 2);
    const std::optional<std::size_t> from = start_of(L, 3, subject.size());
    if (!from) {
        lua_pushnil(L);
        return 1;
    }
    if (find && (lua_toboolean(L, 4) != 0 || text.find_first_of("^$*+?.([%-") == std::string_view::npos)) {
        return push_plain_find(L, subject, text, *from);
    }
    const Pattern pattern(text, true);
    const std::optional<PatternMatch> match = search(L, pattern, subject, *from);
    if (!match) {
        lua_pushnil(L);
        return 1;
    }
    if (find) {
        lua_pushinteger(L, static_cast<lua_Integer>(match->begin + 1));
        lua_pushinteger(L, static_cast<lua_Integer>(match->end));
        return 2 + push_captures(L, subject, *match, false);
    }
    return push_captures(L, subject, *match, true);
}

int find(lua_State* L) { return find_or_match(L, true); }
int match(lua_State* L) { return find_or_match(L, false); }

// Upvalues: subject, pattern, where to look next, where the last match ended (-1: none).
int next_match(lua_State* L) {
    const std::string_view subject = check_text(L, lua_upvalueindex(1));
    const Pattern pattern(check_text(L, lua_upvalueindex(2)), false);
    const auto from = static_cast<std::size_t>(lua_tointeger(L, lua_upvalueindex(3)));
    const lua_Integer last = lua_tointeger(L, lua_upvalueindex(4));
    for (std::size_t at = from; at <= subject.size(); ++at) {
        const std::optional<PatternMatch> found = match_at(L, pattern, subject, at);
        if (found && static_cast<lua_Integer>(found->end) != last) {
            lua_pushinteger(L, static_cast<lua_Integer>(found->end));
            lua_copy(L, -1, lua_upvalueindex(3));
            lua_replace(L, lua_upvalueindex(4));
            return push_captures(L, subject, *found, true);
        }
    }
    return 0;
}

int gmatch(lua_State* L) {
    const std::string_view subject = check_text(L, 1);
    const Pattern checked(check_text(L, 2), false);  // a malformed pattern is reported here
    const std::size_t from = start_of(L, 3, subject.size()).value_or(subject.size() + 1);
    lua_settop(L, 2);
    lua_pushinteger(L, static_cast<lua_Integer>(from));
    lua_pushinteger(L, -1);
    lua_pushcclosure(L, guarded<next_match>, 4);
    return 1;
}

// ---- gsub

void append_template(lua_State* L, std::string& out, std::string_view text, std::string_view subject,
                     const PatternMatch& match) {
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] != '%') {
            out += text[k];
            continue;
        }
        const char c = ++k < text.size() ? text[k] : '\0';
        if (c == '%') {
            out += c;
        } else if (c == '0' || (c == '1' && match.captures.empty())) {
            out += subject.substr(match.begin, match.end - match.begin);
        } else if (c > '0' && c <= '9' && static_cast<std::size_t>(c - '1') < match.captures.size()) {
            push_capture(L, subject, match.captures[static_cast<std::size_t>(c - '1')]);
            out += lua_tostring(L, -1);
            lua_pop(L, 1);
        } else if (c > '0' && c <= '9') {
            luaL_error(L, "invalid capture index %%%c", c);
        } else {
            luaL_error(L, "invalid use of '%%' in replacement string");
        }
    }
}

// What a function or table at index 3 says; false and nil keep the match.
void append_value(lua_State* L, std::string& out, std::string_view subject, const PatternMatch& match) {
    if (lua_type(L, 3) == LUA_TFUNCTION) {
        lua_pushvalue(L, 3);
        lua_call(L, push_captures(L, subject, match, true), 1);
    } else {
        push_capture(L, subject,
                     match.captures.empty() ? PatternCapture{match.begin, match.end, false} : match.captures[0]);
        lua_gettable(L, 3);
    }
    if (lua_toboolean(L, -1) == 0) {
        out += subject.substr(match.begin, match.end - match.begin);
    } else if (lua_isstring(L, -1) != 0) {
        out += check_text(L, -1);
    } else {
        luaL_error(L, "invalid replacement value (a %s)", luaL_typename(L, -1));
    }
    lua_pop(L, 1);
}

// The result lives outside Lua's memory while it grows: hold it to the same limit.
void check_size(lua_State* L, std::size_t size) {
    const std::size_t limit = context(L).options.limits.memory_bytes;
    if (limit != 0 && size > limit) {
        luaL_error(L, "result of string.gsub is larger than the memory limit");
    }
}

int gsub(lua_State* L) {
    const std::string_view subject = check_text(L, 1);
    const Pattern pattern(check_text(L, 2), true);
    const int kind = lua_type(L, 3);
    const bool is_text = kind == LUA_TSTRING || kind == LUA_TNUMBER;
    luaL_argexpected(L, is_text || kind == LUA_TFUNCTION || kind == LUA_TTABLE, 3, "string/function/table");
    const std::string_view text = is_text ? check_text(L, 3) : std::string_view();
    const lua_Integer most = luaL_optinteger(L, 4, static_cast<lua_Integer>(subject.size()) + 1);
    std::string out;
    lua_Integer count = 0;
    std::size_t at = 0;
    std::size_t last = std::string_view::npos;
    while (count < most) {
        const std::optional<PatternMatch> found = match_at(L, pattern, subject, at);
        if (found && found->end != last) {
            ++count;
            is_text ? append_template(L, out, text, subject, *found) : append_value(L, out, subject, *found);
            check_size(L, out.size());
            charge(L, static_cast<long long>(text.size()));
            at = last = found->end;
        } else if (at < subject.size()) {
            out += subject[at++];
        } else {
            break;
        }
        if (pattern.anchored()) {
            break;
        }
    }
    out += subject.substr(std::min(at, subject.size()));
    lua_pushlstring(L, out.data(), out.size());
    lua_pushinteger(L, count);
    return 2;
}

// ---- rep and format

int rep(lua_State* L) {
    const std::string_view text = check_text(L, 1);
    const lua_Integer count = luaL_checkinteger(L, 2);
    const std::string_view between = lua_isnoneornil(L, 3) ? std::string_view() : check_text(L, 3);
    const std::size_t unit = text.size() + between.size();
    if (count <= 0 || unit == 0) {
        lua_pushliteral(L, "");
        return 1;
    }
    if (static_cast<std::size_t>(count) > static_cast<std::size_t>(std::numeric_limits<int>::max()) / unit) {
        return luaL_error(L, "resulting string too large");
    }
    const std::size_t size = unit * static_cast<std::size_t>(count) - between.size();
    luaL_Buffer buffer;
    char* out = luaL_buffinitsize(L, &buffer, size);  // memory limit applies here
    for (std::size_t at = 0; at < size; at += unit) {
        std::copy(text.begin(), text.end(), out + at);
        if (at + unit < size) {
            std::copy(between.begin(), between.end(), out + at + text.size());
        }
    }
    charge(L, static_cast<long long>(size / 64 + static_cast<std::size_t>(count) / 8));
    luaL_pushresultsize(&buffer, size);
    return 1;
}

// Replaces arguments of %s that are no strings by what tostring shows; upvalue 1 is the stock format.
int format(lua_State* L) {
    const std::string_view text = check_text(L, 1);
    int argument = 1;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] != '%') {
            continue;
        }
        k = text.find_first_not_of("-+ #0123456789.", k + 1);
        if (k == std::string_view::npos) {
            break;
        }
        argument += text[k] == '%' ? 0 : 1;
        if (text[k] == 'p') {
            return luaL_error(L, "string.format: %%p shows an address, which differs from run to run");
        }
        if (text[k] == 's' && argument <= lua_gettop(L)) {
            push_text(L, argument);
            lua_replace(L, argument);
        }
    }
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

}  // namespace

void open_strings(lua_State* L) {
    const luaL_Reg functions[] = {{"find", guarded<find>}, {"match", guarded<match>}, {"gmatch", guarded<gmatch>},
                                  {"gsub", guarded<gsub>}, {"rep", guarded<rep>},     {nullptr, nullptr}};
    lua_getglobal(L, "string");
    luaL_setfuncs(L, functions, 0);
    lua_getfield(L, -1, "format");
    lua_pushcclosure(L, guarded<format>, 1);
    lua_setfield(L, -2, "format");
    lua_pop(L, 1);
}

}  // namespace rhexis::lua
