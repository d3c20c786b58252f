// SPDX-License-Identifier: GPL-3.0-or-later
// The shared object with everything that opens a window, loaded by the commands that need it.
#pragma once

#include <dlfcn.h>

#include <CLI/CLI.hpp>

#include "base/assert.hpp"
#include "base/result.hpp"

namespace rhexis::cli {

/// From beside the program, or from where it is installed. It stays loaded: threads of its libraries may not end with
/// it.
Result<void*> load_station();

/// The options --width and --height of a command with a window. They hold what they are if not given.
void add_window_size(CLI::App& command, int& width, int& height);

template <typename Function>
Function* entry_of(void* opened, const char* name) {
    void* entry = ::dlsym(opened, name);
    RHEXIS_ASSERT(entry != nullptr);
    return reinterpret_cast<Function*>(entry);
}

}  // namespace rhexis::cli
