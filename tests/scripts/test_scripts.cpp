// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the cases of tests/scripts/test_*.lua in the sandbox that exercises run in.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "lua/lua_state.hpp"
#include "lua/stack.hpp"

using namespace rhexis;

namespace {

std::vector<std::string> test_files() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator("tests/scripts")) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("test_") && name.ends_with(".lua")) {
            names.push_back(name);
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// harness.compile(text, name, globals): a function; scripts under test have no `load`.
int compile(lua_State* L) {
    lua::load_text(L, luaL_checkstring(L, 1), luaL_checkstring(L, 2));
    lua_pushvalue(L, 3);
    lua_setupvalue(L, -2, 1);
    return 1;
}

LuaState make_state() {
    LuaOptions options;
    options.limits.instructions = 200'000'000;
    options.limits.cpu_seconds = 120.0;
    options.folders = {{"scripts", "scripts"}, {"tests/scripts", "tests"}};
    Result<LuaState> state = LuaState::create(std::move(options));
    REQUIRE(state.ok());
    const Status opened = state.value().run([](lua_State* L) {
        lua_newtable(L);
        lua_pushcfunction(L, compile);
        lua_setfield(L, -2, "compile");
        lua_newtable(L);
        lua_setfield(L, -2, "cases");
        lua_setglobal(L, "harness");
    });
    REQUIRE(opened.ok());
    return std::move(state).value();
}

void push_cases(lua_State* L) {
    lua_getglobal(L, "harness");
    lua_getfield(L, -1, "cases");
    lua_remove(L, -2);
}

std::size_t count_cases(LuaState& state) {
    std::size_t count = 0;
    const Status counted = state.run([&](lua_State* L) {
        push_cases(L);
        count = lua_rawlen(L, -1);
    });
    CHECK(counted.ok());
    return count;
}

void run_case(LuaState& state, std::size_t number) {
    std::string name;
    const Status passed = state.run([&](lua_State* L) {
        push_cases(L);
        lua_rawgeti(L, -1, static_cast<lua_Integer>(number));
        lua_getfield(L, -1, "name");
        name = lua_tostring(L, -1);
        lua_pop(L, 1);
        lua_getfield(L, -1, "run");
        lua_call(L, 0, 0);
    });
    const std::string complaint = passed ? "" : name + "\n" + passed.error().text() + "\n" + state.traceback();
    CHECK_MESSAGE(passed.ok(), complaint);
}

}  // namespace

TEST_CASE("the scripts that curricula share keep their promises") {
    const std::vector<std::string> files = test_files();
    REQUIRE(!files.empty());
    for (const std::string& file : files) {
        CAPTURE(file);
        LuaState state = make_state();
        const Status loaded = state.run_file("tests/scripts/" + file, "tests/" + file);
        const std::string complaint = loaded ? "" : loaded.error().text();
        CHECK_MESSAGE(loaded.ok(), complaint);
        const std::size_t count = count_cases(state);
        CHECK(count > 0);
        for (std::size_t i = 1; i <= count; ++i) {
            run_case(state, i);
        }
    }
}
