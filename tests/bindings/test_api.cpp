// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's modules against their description, both ways; every example runs.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "lua/script.hpp"

using namespace rhexis;

namespace {

ScriptOutcome run(const std::string& path, const std::vector<std::string>& args = {}, std::string* printed = nullptr) {
    ScriptOptions options;
    options.print = [printed](std::string_view line) {
        if (printed != nullptr) {
            *printed += std::string(line) + "\n";
        }
    };
    return run_script(path, args, options);
}

void expect_success(const ScriptOutcome& outcome) {
    INFO(outcome.error);
    CHECK(outcome.exit_status == 0);
}

std::string read_file(const std::string& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_SUITE("bindings") {
    TEST_CASE("the live API and its stubs name the same things") {
        expect_success(run("tests/bindings/api_matches_stubs.lua"));
    }

    TEST_CASE("the words of scenario tests and their stubs are the same") {
        expect_success(run("tests/bindings/scenario_words.lua"));
    }

    TEST_CASE("every example of the stubs runs") { expect_success(run("tests/bindings/stub_examples.lua")); }

    TEST_CASE("bodies and sheets of a scene of one's own do what closed forms say") {
        expect_success(run("tests/bindings/bodies.lua"));
    }

    TEST_CASE("docs/api.md is what the stubs say") {
        // docs/api.md is made by: rhexis lua scripts/dev/api/reference.lua > docs/api.md
        expect_success(run("tests/bindings/reference_is_fresh.lua"));
    }

    TEST_CASE("the examples in docs run") {
        const std::string picture = (std::filesystem::temp_directory_path() / "rhexis-example.png").string();
        for (const char* name : {"bar", "ball_poke", "lens_in_bag", "groove", "determinism"}) {
            CAPTURE(name);
            std::filesystem::remove(picture);
            std::string printed;
            expect_success(run(std::string("docs/examples/") + name + ".lua", {picture}, &printed));
            CHECK(!printed.empty());
            if (std::string(name) == "bar" || std::string(name) == "groove") {
                CHECK(read_file(picture).find("PNG") == 1);
            }
        }
        std::filesystem::remove(picture);
    }
}
