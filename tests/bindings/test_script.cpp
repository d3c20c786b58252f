// SPDX-License-Identifier: GPL-3.0-or-later
// A user's own script: arguments, errors, and how mistakes in options are told.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "lua/script.hpp"

using namespace rhexis;

namespace {

struct Ran {
    ScriptOutcome outcome;
    std::string printed;
};

Ran run_text(const std::string& text, const std::vector<std::string>& args = {}, bool verbose = false) {
    const std::string path = (std::filesystem::temp_directory_path() / "rhexis-test-script.lua").string();
    std::ofstream(path) << text;
    Ran ran;
    ScriptOptions options;
    options.verbose = verbose;
    options.print = [&ran](std::string_view line) { ran.printed += std::string(line) + "\n"; };
    ran.outcome = run_script(path, args, options);
    std::filesystem::remove(path);
    return ran;
}

// What a one-line script complains of, without "file:line: ".
std::string complaint(const std::string& text) {
    const Ran ran = run_text(text);
    CHECK(ran.outcome.exit_status == 1);
    const std::size_t at = ran.outcome.error.find(".lua:1: ");
    REQUIRE_MESSAGE(at != std::string::npos, (text + " -> " + ran.outcome.error));
    CHECK(ran.outcome.error.find('\n') == std::string::npos);
    return ran.outcome.error.substr(at + 8);
}

}  // namespace

TEST_SUITE("bindings") {
    TEST_CASE("a script gets its arguments and all standard libraries") {
        const Ran ran =
            run_text("print(arg[1], arg[2], select('#', ...), type(io), type(os), type(debug))", {"a", "b"});
        CHECK(ran.outcome.exit_status == 0);
        CHECK(ran.printed == "a\tb\t2\ttable\ttable\ttable\n");
    }

    TEST_CASE("a script error is one line with its place, and a call stack only when asked for") {
        const Ran quiet = run_text("local function f()\n error('oh')\nend\nf()");
        CHECK(quiet.outcome.exit_status == 1);
        CHECK(quiet.outcome.error.ends_with("rhexis-test-script.lua:2: oh"));
        CHECK(quiet.outcome.traceback.empty());
        const Ran verbose = run_text("local function f()\n error('oh')\nend\nf()", {}, true);
        CHECK(verbose.outcome.traceback.find("stack traceback") != std::string::npos);
    }

    TEST_CASE("a missing script is bad input") {
        const ScriptOutcome outcome = run_script("nowhere.lua", {}, {});
        CHECK(outcome.exit_status == 2);
        CHECK(outcome.error == "nowhere.lua: there is no such script, or it cannot be read");
        CHECK(run_script("docs", {}, {}).exit_status == 2);
    }

    TEST_CASE("a script may begin with a #! line") {
        CHECK(run_text("#!/usr/bin/rhexis lua\nprint('x')").printed == "x\n");
        CHECK(run_text("#!/usr/bin/rhexis lua\nerror('x')").outcome.error.ends_with(".lua:2: x"));
    }

    TEST_CASE("math.random is seeded and pairs is ordered in scripts too") {
        CHECK(run_text("print(math.random(1000000))").printed == run_text("print(math.random(1000000))").printed);
        CHECK(run_text("local s = '' for k in pairs { c = 1, a = 1, b = 1 } do s = s .. k end print(s)").printed ==
              "abc\n");
    }

    TEST_CASE("mistakes in options say field, value and what is allowed") {
        CHECK(complaint("rhexis.mesh.ball { radius = -1 }") ==
              "rhexis.mesh.ball: radius = -1: allowed: 0.001 to 1000 mm");
        CHECK(complaint("rhexis.mesh.ball { radius = 0/0 }").find("allowed: 0.001 to 1000 mm") != std::string::npos);
        CHECK(complaint("rhexis.mesh.ball { radius = 'big' }") ==
              "rhexis.mesh.ball: radius = \"big\": allowed: 0.001 to 1000 mm");
        CHECK(complaint("rhexis.mesh.ball { radios = 1 }") ==
              "rhexis.mesh.ball: unknown field 'radios' (did you mean radius?)");
        CHECK(complaint("rhexis.mesh.ball { tetrahedra = 500.5 }") ==
              "rhexis.mesh.ball: tetrahedra = 500.5: allowed: a whole number");
        CHECK(complaint("rhexis.mesh.bar { cells = { 1, 2 } }") ==
              "rhexis.mesh.bar: cells = a table: allowed: three finite numbers {x, y, z}");
        CHECK(complaint("rhexis.mesh.bar { cells = { 0, 2, 2 } }").find("1 to 200") != std::string::npos);
        CHECK(complaint("rhexis.mesh.bar(3)") == "rhexis.mesh.bar: expected a table of options, got 3");
        CHECK(complaint("rhexis.mesh.read('nowhere.vtk')").find("nowhere.vtk") != std::string::npos);
        CHECK(complaint("rhexis.scene.create():add_solid {}") ==
              "add_solid: mesh = nil: allowed: a mesh from rhexis.mesh");
        CHECK(complaint("rhexis.scene.create():add_solid { mesh = rhexis.mesh.bar(), poisson_ratio = 0.5 }") ==
              "add_solid: poisson_ratio = 0.5: allowed: 0 to 0.499");
        CHECK(complaint("rhexis.scene.create():add_solid { mesh = rhexis.mesh.bar(), fixed = { 82 } }") ==
              "add_solid: fixed: entry 1 = 82: allowed: whole numbers from 1 to 81");
        CHECK(complaint("rhexis.scene.create():add_solid { mesh = rhexis.mesh.bar(), advance = 'implicitly' }") ==
              "add_solid: advance = \"implicitly\": allowed: automatic, explicit, implicit");
        CHECK(complaint("rhexis.eye.create { age = 140 }") == "rhexis.eye.create: age = 140: allowed: 20 to 95 years");
    }

    TEST_CASE("a closed or foreign object is a sentence, not a crash") {
        CHECK(complaint("local m = rhexis.mesh.bar() m:close() m:info()") == "this rhexis.Mesh was closed");
        CHECK(complaint("local s = rhexis.scene.create() local b = s:add_ball() s:close() b:position()") ==
              "the scene of this rhexis.Tool was closed");
        CHECK(complaint("local m = rhexis.mesh.bar() m:close() m:close() rhexis.mesh.bar() m:info()") ==
              "this rhexis.Mesh was closed");
        CHECK(complaint("rhexis.mesh.bar().info(rhexis.scene.create())").find("rhexis.Mesh expected") !=
              std::string::npos);
        CHECK(complaint("rhexis.mesh.bar():select(function() error('mine', 0) end)") == "mine");
        CHECK(complaint("rhexis.mesh.bar():node(100)").find("100 is out of range: 1 to 81") != std::string::npos);
        CHECK(complaint("rhexis.scene.create():tool('phaco')") == "this scene has no tool 'phaco' (there is none)");
        CHECK(complaint("rhexis.scene.create():observation()").find("only the scene of an eye") != std::string::npos);
    }

    TEST_CASE("parts keep their scene alive, and everything goes with the state") {
        const Ran ran = run_text(
            "local ball do local s = rhexis.scene.create() ball = s:add_ball { position = { 1, 2, 3 } } end\n"
            "collectgarbage() collectgarbage() print(ball:position()[3])\n"
            "for i = 1, 200 do rhexis.mesh.bar() end");
        CHECK(ran.outcome.error == "");
        CHECK(ran.printed == "3.0\n");
    }
}
