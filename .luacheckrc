-- SPDX-License-Identifier: GPL-3.0-or-later
std = "lua54"
max_line_length = 120
read_globals = { "rhexis" }
exclude_files = { "build" }
files["curricula"] = { read_globals = { "exercise", "step", "error_event", "osacss", "rubric" } }
files["tests/scripts"] = { read_globals = { "harness" } }
