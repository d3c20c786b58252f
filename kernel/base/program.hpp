// SPDX-License-Identifier: GPL-3.0-or-later
// The program that runs, and the shared objects that lie beside it.
#pragma once

#include <dlfcn.h>

#include <string>

#include "base/assert.hpp"
#include "base/result.hpp"

namespace rhexis {

/// As the system says, or, where there is no /proc, as it was called.
std::string program_path();

/// Opens library ("rhexis-window.so") from beside the program, from lib/rhexis of where it is installed, or from the
/// build that the program belongs to. It stays loaded: threads of its libraries may not end with it. what: it is, for
/// the error.
Result<void*> load_library(const std::string& library, const std::string& what);

template <typename Function>
Function* entry_of(void* opened, const char* name) {
    void* entry = ::dlsym(opened, name);
    RHEXIS_ASSERT(entry != nullptr);
    return reinterpret_cast<Function*>(entry);
}

}  // namespace rhexis
