// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/script.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "lua/lua_state.hpp"
#include "lua/modules.hpp"
#include "lua/stack.hpp"

namespace rhexis {
namespace {

void print_message(std::string_view line) {
    std::fwrite(line.data(), 1, line.size(), stdout);
    std::fputc('\n', stdout);
}

// arg[0] is the script, arg[1] its first argument, as in the stand-alone interpreter.
void set_arguments(lua_State* L, const std::string& path, const std::vector<std::string>& args) {
    lua::push(L, args);
    lua::push(L, std::string_view(path));
    lua_rawseti(L, -2, 0);
    lua_setglobal(L, "arg");
}

/// A searcher before Lua's own of files: NAME.lua beside the script. Not by package.path, in which ; and ? are no
/// letters.
int find_beside(lua_State* L) {
    std::string name = luaL_checkstring(L, 1);
    std::replace(name.begin(), name.end(), '.', '/');
    const std::string path = (std::filesystem::path(lua_tostring(L, lua_upvalueindex(1))) / (name + ".lua")).string();
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        lua::push(L, std::string_view("no file '" + path + "'"));
        return 1;
    }
    lua::load_file(L, path, path);
    lua::push(L, std::string_view(path));
    return 2;
}

void search_beside(lua_State* L, const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    lua_getglobal(L, "package");
    lua_getfield(L, -1, "searchers");
    for (lua_Integer i = luaL_len(L, -1); i >= 2; --i) {  // the first is for what is preloaded
        lua_rawgeti(L, -1, i);
        lua_rawseti(L, -2, i + 1);
    }
    lua::push(L, std::string_view(folder.empty() ? "." : folder));
    lua_pushcclosure(L, lua::guarded<find_beside>, 1);
    lua_rawseti(L, -2, 2);
    lua_pop(L, 2);
}

LuaOptions state_options(const ScriptOptions& options) {
    LuaOptions lua;
    lua.kind = LuaKind::script;
    lua.limits = {0, 0, 0.0};
    lua.seed = options.seed;
    lua.print = options.print ? options.print : print_message;
    return lua;
}

ScriptOutcome run(const std::string& path, const std::vector<std::string>& args, const ScriptOptions& options) {
    Result<LuaState> state = LuaState::create(state_options(options));
    if (!state) {
        return {2, state.error().text(), ""};
    }
    Status status = state.value().run([&](lua_State* L) {
        lua::open_modules(L);
        set_arguments(L, path, args);
        search_beside(L, path);
    });
    if (status) {
        status = state.value().run_file(path, path, args);
    }
    std::fflush(stdout);
    if (status) {
        return {};
    }
    return {1, status.error().text(), options.verbose ? state.value().traceback() : ""};
}

}  // namespace

ScriptOutcome run_script(const std::string& path, const std::vector<std::string>& args, const ScriptOptions& options) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored) || !std::ifstream(path)) {
        return {2, path + ": there is no such script, or it cannot be read", ""};
    }
    try {
        return run(path, args, options);
    } catch (const std::exception& error) {
        return {1, path + ": " + error.what(), ""};
    }
}

}  // namespace rhexis
