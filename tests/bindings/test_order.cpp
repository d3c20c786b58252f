// SPDX-License-Identifier: GPL-3.0-or-later
// Walking tables in the same order in every run, and sorting the same way.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "lua/json.hpp"
#include "lua/lua_state.hpp"
#include "lua/stack.hpp"

using namespace rhexis;

namespace {

std::string output(const std::string& text) {
    std::string all;
    LuaOptions options;
    options.print = [&all](std::string_view line) { all += std::string(line) + "\n"; };
    Result<LuaState> state = LuaState::create(std::move(options));
    REQUIRE(state.ok());
    const Status status = state.value().run_text(text, "order.lua");
    return status.ok() ? all : status.error().text();
}

}  // namespace

TEST_SUITE("bindings") {
    TEST_CASE("pairs walks numbers, then names, then booleans, each sorted") {
        CHECK(output("local t = {[true]=1, [false]=2, b=3, a=4, [10]=5, [-1]=6, [2.5]=7, [2]=8, B=9, ['']=10}\n"
                     "local s = '' for k, v in pairs(t) do s = s .. tostring(k) .. '=' .. v .. ' ' end print(s)") ==
              "-1=6 2=8 2.5=7 10=5 =10 B=9 a=4 b=3 false=2 true=1 \n");
    }

    TEST_CASE("next walks the same order as pairs, from any key") {
        CHECK(output("local t = {z=1, a=2, 'x', 'y', [false]=3}\n"
                     "local a, b = {}, {}\n"
                     "for k in pairs(t) do a[#a + 1] = tostring(k) end\n"
                     "for k in next, t do b[#b + 1] = tostring(k) end\n"
                     "print(table.concat(a, ' '), table.concat(b, ' '), next(t, 'a'))\n"
                     "print(next({}), next({}, nil), next(t, false))") ==
              "1 2 a z false\t1 2 a z false\tz\t1\nnil\tnil\tnil\n");
    }

    TEST_CASE("fields may become nil while a table is walked") {
        CHECK(output("local t = {a=1, b=2, c=3, d=4, e=5}\n"
                     "local s = '' for k in pairs(t) do s = s .. k; t[k] = nil; t.c = nil end print(s, next(t))\n"
                     "t = {a=1, b=2, c=3} s = ''\n"
                     "local k = next(t) while k do s = s .. k; t[k] = nil; t.b = nil; k = next(t, k) end print(s)\n"
                     "t = {1, 2, 3, 4} s = '' for i, v in pairs(t) do s = s .. v; t[i + 1] = nil end print(s)") ==
              "abde\tnil\nac\n13\n");
    }

    TEST_CASE("existing fields may be assigned while a table is walked") {
        CHECK(output("local t = {a=1, b=2} for k, v in pairs(t) do t[k] = v * 10; t.b = 7 end print(t.a, t.b)") ==
              "10\t7\n");
    }

    TEST_CASE("one key that is an object may be walked, two may not") {
        CHECK(output("local o = {} local t = {[o]=1, a=2} local n = 0 for k, v in pairs(t) do n = n + v end print(n)\n"
                     "print(next({[o]=1}) == o, next({[o]=1}, o))") == "3\ntrue\tnil\n");
        const std::string error = output("\nfor k in pairs({[{}]=1, [{}]=2}) do end");
        CHECK(error.starts_with("order.lua:2: this table has several keys of type table"));
    }

    TEST_CASE("a __pairs metamethod is respected") {
        CHECK(
            output("local t = setmetatable({}, {__pairs = function(t) return function(_, k) if not k then return 1, 2 "
                   "end end, t, nil end}) for k, v in pairs(t) do print(k, v) end") == "1\t2\n");
    }

    TEST_CASE("huge integers and floats next to them stay apart") {
        CHECK(output("local t = {[2^53]=1, [9007199254740993]=2, [1e300]=3, [math.mininteger]=4}\n"
                     "local s = '' for _, v in pairs(t) do s = s .. v end print(s)") == "4123\n");
    }

    TEST_CASE("table.sort is stable and does not depend on chance") {
        CHECK(output("local t = {} for i = 1, 500 do t[i] = {i % 7, i} end\n"
                     "table.sort(t, function(a, b) return a[1] < b[1] end)\n"
                     "local good = true for i = 2, #t do local a, b = t[i - 1], t[i]\n"
                     "good = good and (a[1] < b[1] or (a[1] == b[1] and a[2] < b[2])) end print(good)\n"
                     "local u = {3, 1, 2} table.sort(u) print(u[1], u[2], u[3])\n"
                     "u = {'b', 'a'} table.sort(u, function(a, b) return a > b end) print(u[1], u[2])\n"
                     "table.sort({}) u = {1} table.sort(u) print(u[1])") == "true\n1\t2\t3\nb\ta\n1\n");
        CHECK(output("table.sort({1, 'a'})").starts_with("order.lua:1: attempt to compare"));
    }

    TEST_CASE("tables become JSON with sorted keys, and come back") {
        LuaOptions options;
        Result<LuaState> state = LuaState::create(std::move(options));
        REQUIRE(state.ok());
        const Status status = state.value().run([](lua_State* L) {
            lua::load_text(
                L, "return {b={1, 2.5, 'x'}, a={deep={t=true}}, n=0/0, e={}, o=setmetatable({}, {__json='object'})}",
                "j.lua");
            lua_call(L, 0, 1);
            const nlohmann::json value = lua::to_json(L, -1);
            CHECK(value.dump() == R"({"a":{"deep":{"t":true}},"b":[1,2.5,"x"],"e":[],"n":null,"o":{}})");
            lua::push_json(L, value);
            CHECK(lua::to_json(L, -1)["a"]["deep"]["t"] == true);
        });
        CHECK(status.ok());
        for (const char* text : {"local t = {} t.t = t return t", "return {1, nil, 3, x=1}", "return {f=print}"}) {
            const Status bad = state.value().run([text](lua_State* L) {
                lua::load_text(L, text, "j.lua");
                lua_call(L, 0, 1);
                static_cast<void>(lua::to_json(L, -1));
            });
            REQUIRE(!bad.ok());
            CHECK(bad.error().text().find("cannot become JSON") != std::string::npos);
        }
    }
}
