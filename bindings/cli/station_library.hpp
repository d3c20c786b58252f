// SPDX-License-Identifier: GPL-3.0-or-later
// Shared objects that the commands which need them load: one with everything that opens a window, one with cameras and
// calibration.
#pragma once

#include <CLI/CLI.hpp>

#include "base/program.hpp"

namespace rhexis::cli {

Result<void*> load_station();
Result<void*> load_tracking();

/// The options --width and --height of a command with a window. They hold what they are if not given.
void add_window_size(CLI::App& command, int& width, int& height);

}  // namespace rhexis::cli
