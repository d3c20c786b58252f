// SPDX-License-Identifier: GPL-3.0-or-later
// Shared objects that the commands which need them load: one with everything that opens a window, one with cameras and
// calibration.
#pragma once

#include <dlfcn.h>

#include <CLI/CLI.hpp>

#include "base/assert.hpp"
#include "base/result.hpp"

namespace rhexis::cli {

/// From beside the program, or from where it is installed. They stay loaded: threads of their libraries may not end
/// with them.
Result<void*> load_station();
Result<void*> load_tracking();

/// The options --width and --height of a command with a window. They hold what they are if not given.
void add_window_size(CLI::App& command, int& width, int& height);

template <typename Function>
Function* entry_of(void* opened, const char* name) {
    void* entry = ::dlsym(opened, name);
    RHEXIS_ASSERT(entry != nullptr);
    return reinterpret_cast<Function*>(entry);
}

}  // namespace rhexis::cli
