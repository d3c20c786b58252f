// SPDX-License-Identifier: GPL-3.0-or-later
// What a script may try, and what must come of it: one clear line with file:line, and a state that closes at once.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "lua/lua_state.hpp"
#include "lua/stack.hpp"

using namespace rhexis;

namespace {

LuaState make_state(std::vector<std::string>* printed = nullptr) {
    LuaOptions options;
    options.limits.memory_bytes = std::size_t{16} << 20;
    options.limits.instructions = 2'000'000;
    options.folders = {{"tests/bindings/modules", "modules"}};
    if (printed != nullptr) {
        options.print = [printed](std::string_view line) { printed->emplace_back(line); };
    }
    Result<LuaState> state = LuaState::create(std::move(options));
    REQUIRE(state.ok());
    return std::move(state).value();
}

// The error line of a script that must fail.
std::string failure(const std::string& text) {
    LuaState state = make_state();
    const Status status = state.run_text(text, "try.lua");
    REQUIRE_MESSAGE(!status.ok(), text);
    CHECK(status.error().text().find('\n') == std::string::npos);
    // The state still works afterwards.
    const Status again = state.run_text("assert(1 + 1 == 2)", "again.lua");
    CHECK_MESSAGE(again.ok(), text);
    return status.error().text();
}

// Runs a script that must succeed and gives what it printed.
std::vector<std::string> printed(const std::string& text) {
    std::vector<std::string> lines;
    LuaState state = make_state(&lines);
    const Status status = state.run_text(text, "try.lua");
    REQUIRE_MESSAGE(status.ok(), (status.ok() ? "" : status.error().text()));
    return lines;
}

void expect_stopped(const std::string& text, const std::string& place) {
    const std::string line = failure(text);
    CHECK_MESSAGE(line.starts_with(place + ": stopped: used up its budget of 2000000 instructions"),
                  (text + "\n-> " + line));
}

}  // namespace

TEST_SUITE("bindings") {
    TEST_CASE("an endless loop ends with the budget") {
        expect_stopped("local n = 0\nwhile true do\n n = n + 1\nend", "try.lua:3");
    }

    TEST_CASE("an endless loop cannot hide in pcall, xpcall, a coroutine or a metamethod") {
        expect_stopped("while true do pcall(function() while true do end end) end", "try.lua:1");
        expect_stopped("xpcall(function() while true do end end, function() while true do end end)", "try.lua:1");
        expect_stopped("xpcall(error, function()\nwhile true do end end)", "try.lua:2");
        expect_stopped("coroutine.wrap(function()\n while true do end end)()", "try.lua:2");
        expect_stopped(
            "while true do pcall(coroutine.wrap(function() pcall(function() while true do end end) end)) end",
            "try.lua:1");
        expect_stopped("local t = setmetatable({}, {__index = function()\n while true do end end})\nreturn t.x",
                       "try.lua:2");
        expect_stopped(
            "local t = setmetatable({}, {__close = function()\n while true do end end})\nlocal x <close> = t",
            "try.lua:2");
        expect_stopped("error(setmetatable({}, {__tostring = function()\n while true do end end}))", "try.lua:2");
    }

    TEST_CASE("coroutines that are made for ever end with the budget") {
        expect_stopped(
            "while true do local c = coroutine.create(function() for i = 1, 50 do end end) "
            "coroutine.resume(c) end",
            "try.lua:1");
    }

    TEST_CASE("a coroutine of an earlier run is stopped too") {
        LuaState state = make_state();
        REQUIRE(state.run_text("spin = coroutine.wrap(function() coroutine.yield() while true do end end) spin()", "a")
                    .ok());
        const Status status = state.run_text("pcall(spin)", "b.lua");
        REQUIRE(!status.ok());
        CHECK(status.error().what.starts_with("stopped: used up its budget"));
    }

    TEST_CASE("an endless comparator of table.sort ends with the budget") {
        expect_stopped("table.sort({3, 1, 2}, function()\n while true do end end)", "try.lua:2");
        expect_stopped("local t = {} for i = 1, 100 do t[i] = i end\nwhile true do table.sort(t, math.max) end",
                       "try.lua:2");
    }

    TEST_CASE("an endless gsub callback ends with the budget") {
        expect_stopped("string.gsub('abc', '.', function()\n while true do end end)", "try.lua:2");
    }

    TEST_CASE("pathological patterns end with the budget") {
        const std::string many = "('a'):rep(30)";
        for (const char* function : {"find", "match", "gsub", "gmatch"}) {
            CAPTURE(function);
            const std::string tail = std::string(function) == "gsub" ? ", '')" : ")";
            const std::string call = "string." + std::string(function) + "(" + many + ", ('a*'):rep(26) .. 'b'" + tail;
            expect_stopped(std::string(function) == "gmatch" ? "for _ in " + call + " do end" : call, "try.lua:1");
        }
        expect_stopped("string.find(('a'):rep(1e6), '.-.-.-b')", "try.lua:1");
        expect_stopped("string.find(('('):rep(1e5), '%b()')", "try.lua:1");
    }

    TEST_CASE("C functions with a length of the script's choosing end with the budget") {
        expect_stopped("table.move({}, 1, 1e9, 2)", "try.lua:1");
        expect_stopped("table.insert(setmetatable({}, {__len = function() return 1e9 end}), 1, 1)", "try.lua:1");
        expect_stopped("table.remove(setmetatable({}, {__len = function() return 1e9 end}), 1)", "try.lua:1");
        CHECK(failure("table.move({}, 1, math.maxinteger - 1, 2)") == "try.lua:1: too many elements");
        CHECK(printed("print(#string.rep('', 1e15))") == std::vector<std::string>{"0"});
    }

    TEST_CASE("building huge strings again and again ends with the budget") {
        expect_stopped("local s = ('x'):rep(4e6)\nwhile true do local t = s .. 'y' end", "try.lua:2");
    }

    TEST_CASE("a memory bomb ends with one line") {
        const std::string limit = "stopped: needs more memory than its limit of 16 MiB";
        CHECK(failure("local t = {}\nfor i = 1, 1e9 do t[i] = {i} end") == "try.lua:2: " + limit);
        CHECK(failure("local s = ('x'):rep(1e9)") == "try.lua:1: " + limit);
        CHECK(failure("local s = 'x'\nwhile true do\n s = s .. s end") == "try.lua:3: " + limit);
        CHECK(failure("local t = {}\nfor i = 1, 1e9 do t[i] = 'name' .. i end") == "try.lua:2: " + limit);
    }

    TEST_CASE("deep recursion ends with one line") {
        const std::string line = failure("local function f(n)\n return 1 + f(n + 1) end\nf(1)");
        CHECK_MESSAGE(line.starts_with("try.lua:2: "), line);
        CHECK(failure("local t = setmetatable({}, {}) getmetatable(t).__index = function(_, k) return t[k + 1] end\n"
                      "return t[1]")
                  .find("overflow") != std::string::npos);
        CHECK(failure("local function f() return pcall(f) end f() error('here')").starts_with("try.lua:1: "));
        CHECK(failure("local function f(s) return (s:gsub('.', f)) end f('a')").find("overflow") != std::string::npos);
    }

    TEST_CASE("finalisers and weak tables are refused") {
        CHECK(failure("setmetatable({}, {__gc = function() while true do end end})") ==
              "try.lua:1: setmetatable: the field __gc is not available to this script");
        CHECK(failure("setmetatable({}, {__mode = 'k'})").find("__mode") != std::string::npos);
        // What a suspended coroutine would close on its way out is dropped with it.
        LuaState suspended = make_state();
        CHECK(suspended
                  .run_text("c = coroutine.wrap(function() local x <close> = setmetatable({}, {__close = function() "
                            "while true do end end}) coroutine.yield() end) c()",
                            "pending")
                  .ok());
        // Added later, it is never looked at: the state must close at once.
        LuaState state = make_state();
        CHECK(state.run_text("m = {} t = setmetatable({}, m) m.__gc = function() while true do end end t = nil", "late")
                  .ok());
    }

    TEST_CASE("nothing that reaches outside is there") {
        for (const char* name :
             {"load", "loadfile", "dofile", "collectgarbage", "warn", "debug", "io", "os", "package", "string.dump"}) {
            CAPTURE(name);
            CHECK(printed("print(" + std::string(name) + ")") == std::vector<std::string>{"nil"});
        }
        CHECK(printed("print(getmetatable(''))") == std::vector<std::string>{"locked"});
        CHECK(failure("setmetatable('', {})").find("bad argument #1 to 'setmetatable'") != std::string::npos);
    }

    TEST_CASE("only text is loaded") {
        LuaState state = make_state();
        const Status status = state.run_text("\x1bLua binary", "binary.lua");
        REQUIRE(!status.ok());
        CHECK(status.error().text() == "binary.lua:1: is precompiled, only text is taken");
    }

    TEST_CASE("require reads script folders only") {
        CHECK(printed("print(require('greeting').hello('you'))") == std::vector<std::string>{"hello you"});
        CHECK(printed("print(require('greeting') == require('greeting'))") == std::vector<std::string>{"true"});
        CHECK(failure("require('nowhere')") == "try.lua:1: require: no module 'nowhere' in modules");
        for (const char* name : {"../secret", "/etc/passwd", "a/b", "..", ".a", ""}) {
            CAPTURE(name);
            CHECK(failure("require('" + std::string(name) + "')").find("is not a module name") != std::string::npos);
        }
        CHECK(failure("require('loop')").find("requires itself") != std::string::npos);
        CHECK(failure("require('broken')").starts_with("modules/broken.lua:4: "));
    }

    TEST_CASE("a syntax error names file and line") {
        CHECK(failure("local x = 1\nlocal = 2").starts_with("try.lua:2: <name> expected near '='"));
    }

    TEST_CASE("an error without a place gets the line that raised it") {
        CHECK(failure("\nerror('bad', 0)") == "try.lua:2: bad");
        CHECK(failure("\nerror({})") == "try.lua:2: error with a table instead of a message");
        CHECK(failure("\nerror()") == "try.lua:2: error with a nil instead of a message");
    }

    TEST_CASE("a C++ exception becomes a Lua error and destructors run") {
        LuaState state = make_state();
        bool destroyed = false;
        struct Flag {
            bool& flag;
            ~Flag() { flag = true; }
        };
        const Status status = state.run([&](lua_State* L) {
            const Flag guard{destroyed};
            luaL_error(L, "raised in C++");
        });
        CHECK(!status.ok());
        CHECK(destroyed);
        const Status thrown = state.run([](lua_State*) { throw std::runtime_error("thrown in C++"); });
        REQUIRE(!thrown.ok());
        CHECK(thrown.error().text() == "thrown in C++");
    }

    TEST_CASE("tostring, print and format show no address") {
        CHECK(printed("print({}, print, coroutine.create(print), 1.5, nil, true, 'x')") ==
              std::vector<std::string>{"table\tfunction\tthread\t1.5\tnil\ttrue\tx"});
        CHECK(printed("print(('%s %5.1f %% %-4s|'):format({}, 2.25, print))") ==
              std::vector<std::string>{"table   2.2 % function|"});
        CHECK(printed("print(setmetatable({}, {__name = 'Probe'}))") == std::vector<std::string>{"Probe"});
        CHECK(failure("print(('%p'):format({}))").find("address") != std::string::npos);
    }

    TEST_CASE("the same seed draws the same numbers") {
        const std::string draw = "print(math.random(), math.random(6), math.random(-3, 3))";
        CHECK(printed(draw) == printed(draw));
        CHECK(printed("math.randomseed(5) local a = math.random() math.randomseed(5) print(a == math.random())") ==
              std::vector<std::string>{"true"});
        CHECK(failure("math.random(0)").find("interval is empty") != std::string::npos);
    }
}
