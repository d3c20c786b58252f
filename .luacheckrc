-- SPDX-License-Identifier: GPL-3.0-or-later
std = "lua54"
max_line_length = 120
read_globals = { "rhexis" }
exclude_files = { "build" }
local exercise_words = { "exercise", "step", "error_event", "request", "operation", "part", "osacss", "rubric" }
files["curricula"] = { read_globals = exercise_words }
files["docs/examples/exercises"] = { read_globals = exercise_words }
files["docs/examples/exercises/*/tests"] = { read_globals = { "scenarios", "scenario" } }
files["rubrics"] = { read_globals = { "rubric" } }
files["curricula/*/tests"] = { read_globals = { "scenarios", "scenario" } }
files["studies/warnings"] = { read_globals = { "scenarios", "scenario" } }
files["curricula/*/starts.lua"] = { read_globals = { "starts" } }
files["tests/bindings/cli/walk"] = { read_globals = { "exercise", "step" } }
files["tests/scripts"] = { read_globals = { "harness" } }
files["bindings/lua/meta/scenario.lua"] = { globals = { "scenarios", "scenario", "starts" } }
-- Stubs declare what C++ defines: empty functions, and fields of the global.
files["bindings/lua/meta"] = { globals = { "rhexis" }, ignore = { "211", "212", "241" } }
