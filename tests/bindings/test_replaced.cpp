// SPDX-License-Identifier: GPL-3.0-or-later
// What the sandbox replaces must behave as in stock Lua: both run the same script, and print the same.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "lua/lua_state.hpp"

using namespace rhexis;

namespace {

std::string output(LuaKind kind, const std::string& path) {
    std::string all;
    LuaOptions options;
    options.kind = kind;
    options.limits.instructions = kind == LuaKind::sandbox ? 500'000'000 : 0;
    options.print = [&all](std::string_view line) { all += std::string(line) + "\n"; };
    Result<LuaState> state = LuaState::create(std::move(options));
    REQUIRE(state.ok());
    const Status status = state.value().run_file(path, "same.lua");
    return status.ok() ? all : all + status.error().text();
}

void expect_same(const std::string& path) {
    const std::string sandboxed = output(LuaKind::sandbox, path);
    const std::string stock = output(LuaKind::script, path);
    CHECK(!stock.empty());
    if (sandboxed != stock) {
        const auto [here, there] = std::mismatch(stock.begin(), stock.end(), sandboxed.begin(), sandboxed.end());
        const auto line = static_cast<std::size_t>(std::count(stock.begin(), here, '\n'));
        FAIL_CHECK("line " << line + 1 << " of what is printed\nstock: ..."
                           << std::string(here, stock.end()).substr(0, 99) << "\nsandbox: ..."
                           << std::string(there, sandboxed.end()).substr(0, 99));
    }
}

}  // namespace

TEST_SUITE("bindings") {
    TEST_CASE("patterns match as in stock Lua") { expect_same("tests/bindings/same/patterns.lua"); }
    TEST_CASE("random patterns match as in stock Lua") { expect_same("tests/bindings/same/random_patterns.lua"); }
    TEST_CASE("mistakes are refused with the words of stock Lua") { expect_same("tests/bindings/same/mistakes.lua"); }
    TEST_CASE("protected calls and coroutines behave as in stock Lua") {
        expect_same("tests/bindings/same/protection.lua");
    }
}
