// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/lua_state.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "base/text_file.hpp"
#include "lua/guard.hpp"
#include "lua/sandbox.hpp"

namespace rhexis {
namespace lua {
namespace {

constexpr char between_mistakes = '\x1e';  // scripts/engine/words.lua

// Position of the colon after "file:line", or npos.
std::size_t end_of_place(const std::string& message) {
    for (std::size_t at = message.find(':'); at != std::string::npos; at = message.find(':', at + 1)) {
        std::size_t end = at + 1;
        while (end < message.size() && std::isdigit(static_cast<unsigned char>(message[end])) != 0) {
            ++end;
        }
        if (end > at + 1 && end + 1 < message.size() && message[end] == ':' && message[end + 1] == ' ') {
            return end;
        }
        if (message[at] == '\n') {
            break;
        }
    }
    return std::string::npos;
}

void push_error_text(lua_State* L) {
    if (lua_type(L, 1) == LUA_TSTRING) {
        lua_pushvalue(L, 1);
    } else if (luaL_callmeta(L, 1, "__tostring") == 0 || lua_type(L, -1) != LUA_TSTRING) {
        lua_pushfstring(L, "error with a %s instead of a message", luaL_typename(L, 1));
    }
}

int message_handler(lua_State* L) {
    push_error_text(L);
    std::string message = lua_tostring(L, -1);
    if (end_of_place(message) == std::string::npos) {
        const std::string where = place(L);
        message = where.empty() ? message : where + ": " + message;
    }
    luaL_traceback(L, L, nullptr, 1);
    context(L).traceback = lua_tostring(L, -1);
    lua_pushlstring(L, message.data(), message.size());
    return 1;
}

int run_body(lua_State* L) {
    const auto& body = *static_cast<const std::function<void(lua_State*)>*>(lua_touserdata(L, 1));
    lua_settop(L, 0);
    body(L);
    return 0;
}

std::string mebibytes(std::size_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

Error error_of(Context& c, lua_State* L, int status) {
    if (status == LUA_ERRMEM) {
        c.traceback.clear();
        return {"stopped: needs more memory than its limit of " + mebibytes(c.options.limits.memory_bytes),
                c.refused_at, ""};
    }
    const char* message = lua_tostring(L, -1);
    return error_from_message(message != nullptr ? message : "unknown error");
}

}  // namespace

Error error_from_message(const std::string& message) {
    std::istringstream all(message);
    std::string first;
    std::getline(all, first, between_mistakes);
    const std::size_t end = end_of_place(first);
    Error error =
        end == std::string::npos ? Error{first, "", ""} : Error{first.substr(end + 2), first.substr(0, end), ""};
    for (std::string other; std::getline(all, other, between_mistakes);) {
        error.more.push_back(other);
    }
    return error;
}

namespace {

/// What most often is behind a message of Lua about the form of a script, for who does not program; or nothing.
std::string_view likely_slip(std::string_view message) {
    const auto says = [message](std::string_view part) { return message.find(part) != std::string_view::npos; };
    if (says("near '<\\194>'") || says("near '<\\160>'")) {
        return ": a no-break space stands there, as word processors and web pages put it; a plain space is meant";
    }
    if (says("near '<\\226>'")) {
        return ": a typographic quotation mark, dash or space stands there; Lua knows the plain ones";
    }
    if (says("near '<\\239>'")) {
        return ": a byte order mark stands there; it may only be at the very beginning";
    }
    if (says("unfinished string")) {
        return ": a quotation mark is missing at the end of a text";
    }
    if (says("'}' expected") && says("near <eof>")) {
        return ": a } is missing";
    }
    if (says("'}' expected")) {
        return ": most often a comma is missing before it, or a quotation mark";
    }
    if (says("<eof> expected")) {
        return ": most often there is a } too many, or a { missing, before it";
    }
    return "";
}

}  // namespace

void load_text(lua_State* L, const std::string& given, const std::string& chunk) {
    const std::string name = "@" + chunk;
    const std::string_view text = without_mark(given);
    if (text.starts_with('\x1b')) {
        luaL_error(L, "%s:1: is precompiled, only text is taken", chunk.c_str());
    }
    // "t": precompiled code could break the interpreter.
    if (luaL_loadbufferx(L, text.data(), text.size(), name.c_str(), "t") != LUA_OK) {
        const std::string_view slip = likely_slip(lua_isstring(L, -1) != 0 ? lua_tostring(L, -1) : "");
        lua_pushlstring(L, slip.data(), slip.size());
        lua_concat(L, 2);
        lua_error(L);
    }
}

void load_file(lua_State* L, const std::string& path, const std::string& chunk) {
    const Result<std::string> read = read_text_file(path, largest_script);
    if (!read) {
        const std::string what = Error{read.error().what, chunk, read.error().allowed}.text();
        luaL_error(L, "%s", what.c_str());
    }
    std::string text = read.value();
    if (without_mark(text).starts_with('#')) {  // "#!" line; its line stays, so that numbers hold
        text = "--" + std::string(without_mark(text));
    }
    load_text(L, text, chunk);
}

}  // namespace lua

Result<LuaState> LuaState::create(LuaOptions options) {
    auto context = std::make_shared<lua::Context>(std::move(options));
    lua_State* L = lua_newstate(lua::allocate, context.get());
    if (L == nullptr) {
        return Error{"cannot start a Lua interpreter", "", "memory limit of at least 1 MiB"};
    }
    *static_cast<lua::Context**>(lua_getextraspace(L)) = context.get();
    context->main = L;
    context->current = L;
    LuaState state(std::move(context));
    const Status opened = state.run([](lua_State* inner) { lua::open_libraries(inner); });
    if (!opened) {
        return opened.error();
    }
    return state;
}

LuaState::~LuaState() {
    if (context_) {
        lua_State* L = context_->main;
        context_->main = nullptr;
        context_->current = nullptr;
        lua_close(L);
    }
}

LuaState::LuaState(LuaState&&) noexcept = default;

LuaState& LuaState::operator=(LuaState&& other) noexcept {
    LuaState old(std::move(*this));
    context_ = std::move(other.context_);
    return *this;
}

Status LuaState::run(const std::function<void(lua_State*)>& body) {
    lua::Context& c = *context_;
    lua_State* L = c.current;
    if (lua_checkstack(L, 3) == 0) {
        return Error{"Lua stack overflow", "", ""};
    }
    const int top = lua_gettop(L);
    lua_pushcfunction(L, lua::guarded<lua::message_handler>);
    lua_pushcfunction(L, lua::guarded<lua::run_body>);
    // Lua takes no pointer to const; run_body only reads it.
    lua_pushlightuserdata(L, const_cast<std::function<void(lua_State*)>*>(&body));
    if (c.depth++ == 0) {
        lua::arm(c);
    }
    const int status = lua_pcall(L, 1, 0, top + 1);
    if (--c.depth == 0) {
        lua::disarm(c);
    }
    Status result = status == LUA_OK ? success() : Status(lua::error_of(c, L, status));
    lua_settop(L, top);
    return result;
}

Status LuaState::run_file(const std::string& path, const std::string& chunk, const std::vector<std::string>& args) {
    return run([&](lua_State* L) {
        lua::load_file(L, path, chunk);
        luaL_checkstack(L, static_cast<int>(args.size()), "too many arguments");
        for (const std::string& arg : args) {
            lua_pushlstring(L, arg.data(), arg.size());
        }
        lua_call(L, static_cast<int>(args.size()), 0);
    });
}

Status LuaState::run_text(const std::string& text, const std::string& chunk) {
    return run([&](lua_State* L) {
        lua::load_text(L, text, chunk);
        lua_call(L, 0, 0);
    });
}

const std::string& LuaState::traceback() const { return context_->traceback; }
std::size_t LuaState::used_bytes() const { return context_->used_bytes; }
Rng& LuaState::rng() { return context_->rng; }
lua_State* LuaState::raw() const { return context_->current; }

LuaRef::LuaRef(const LuaState& state, lua_State* L)
    : context_(state.context_), index_(luaL_ref(L, LUA_REGISTRYINDEX)) {}

LuaRef::~LuaRef() { release(); }

LuaRef::LuaRef(LuaRef&& other) noexcept
    : context_(std::move(other.context_)), index_(std::exchange(other.index_, LUA_NOREF)) {}

LuaRef& LuaRef::operator=(LuaRef&& other) noexcept {
    if (this != &other) {
        release();
        context_ = std::move(other.context_);
        index_ = std::exchange(other.index_, LUA_NOREF);
    }
    return *this;
}

void LuaRef::push(lua_State* L) const {
    if (index_ == LUA_NOREF) {
        lua_pushnil(L);
    } else {
        lua_rawgeti(L, LUA_REGISTRYINDEX, index_);
    }
}

void LuaRef::release() {
    if (const auto context = context_.lock(); context && context->main != nullptr && index_ != LUA_NOREF) {
        luaL_unref(context->main, LUA_REGISTRYINDEX, index_);
    }
    index_ = LUA_NOREF;
}

Status check_form_of(const std::string& path, const std::string& chunk) {
    Result<LuaState> state = LuaState::create({});
    if (!state) {
        return state.error();
    }
    return state.value().run([&](lua_State* L) { lua::load_file(L, path, chunk); });
}

}  // namespace rhexis
