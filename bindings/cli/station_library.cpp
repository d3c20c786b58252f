// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/station_library.hpp"

namespace rhexis::cli {

Result<void*> load_station() { return load_library("rhexis-window.so", "its window"); }

Result<void*> load_tracking() { return load_library("rhexis-track.so", "its tracking"); }

void add_window_size(CLI::App& command, int& width, int& height) {
    command.add_option("--width", width, "Of the window [pixels]")->check(CLI::Range(160, 4096))->capture_default_str();
    command.add_option("--height", height, "Of the window [pixels]")
        ->check(CLI::Range(120, 4096))
        ->capture_default_str();
}

}  // namespace rhexis::cli
