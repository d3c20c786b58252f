// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a whole operation, from those of its parts: report.json and series.json on one clock.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis {

struct OperationOptions;

/// A part that was done.
struct DonePart {
    std::string id;
    std::string title;
    std::string folder;
    nlohmann::json left;  ///< "operation" of the exercise's result: see ExerciseHost::result
};

struct WholeReport {
    nlohmann::json report;
    nlohmann::json series;
};

/// Fails when a part's own report or series cannot be read.
Result<WholeReport> report_of_parts(const OperationOptions& options, const std::vector<DonePart>& parts,
                                    const std::string& script_error);

}  // namespace rhexis
