// SPDX-License-Identifier: GPL-3.0-or-later
// `rhexis lua FILE`: a user's own script with the kernel's modules and all standard libraries. Not sandboxed.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace rhexis {

struct ScriptOptions {
    std::uint64_t seed = 1;                       ///< of math.random
    bool verbose = false;                         ///< a failing script shows its call stack
    std::function<void(std::string_view)> print;  ///< receives printed lines; empty: standard output
};

/// How a script ended.
struct ScriptOutcome {
    int exit_status = 0;    ///< 0 done, 1 the script raised an error, 2 it could not be read
    std::string error;      ///< one line, "file:line: what", if it did not end well
    std::string traceback;  ///< its call stack, if verbose
};

/// Runs a file with `arg` (and `...`) holding args. require also finds modules beside the script. Never throws; the
/// script's own os.exit ends the process.
ScriptOutcome run_script(const std::string& path, const std::vector<std::string>& args, const ScriptOptions& options);

}  // namespace rhexis
