// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt at an operation: its parts one after the other, each an attempt of its own in FOLDER/parts/, and over
// them a report of the whole.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "lua/operation_script.hpp"
#include "trial/attempt.hpp"

namespace rhexis {

struct OperationOptions {
    Operation operation;
    AttemptOptions attempt;  ///< surgeon, seed, root, folder, drawing, ... of every part. In `set`, "PART.goal.NAME"
                             ///< and the like are for one part only
    std::string from;        ///< id of the part to begin with; "": the first
    std::string to;          ///< id of the last part to do; "": the last
    bool resume = false;     ///< parts that are whole in the folder already are not done again
};

struct OperationResult {
    nlohmann::json report;     ///< as written to report.json
    std::string script_error;  ///< one part ended with this, and the operation with it; empty: none did
    std::string drawing_note;  ///< why there are no pictures; empty: there are
    std::string html_error;    ///< why there is no report.html; empty: there is one
    std::vector<std::string> recordings;
};

/// Runs the parts and leaves everything in the folder. An error means bad input or a disk that cannot be written; what
/// parts before have left stays.
Result<OperationResult> operate(const OperationOptions& options);

}  // namespace rhexis
