// SPDX-License-Identifier: GPL-3.0-or-later
// Whether gates do what they are for: experts pass, beginners do not. Tried once on seeds that were never run before
// (rhexis study gates), kept in rubrics/gates_accepted.json, and compared with the gates and exercises of today.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/study_result.hpp"

namespace rhexis::cli {

/// "seeds", and per exercise "decides", "pass", "tells_apart", and per group {"passed", "of"}.
Result<nlohmann::json> gates_tried(const StudyPlan& plan, const std::vector<StudyRun>& runs, const std::string& root);

/// A table of other seeds of the plan, of the exercises and gates of today; else why it cannot be added to.
Result<nlohmann::json> earlier_seeds(const std::string& file, const StudyPlan& plan, const std::string& root);

/// Adds what such a table counted.
void add_earlier(const nlohmann::json& earlier, nlohmann::json& tried);

/// The same as a table in Markdown.
std::string gates_text(const nlohmann::json& tried);

/// What of the kept table is not whole, not true of today's exercises and gates, or does not come up to what is asked:
/// at least 8 of 10 experts pass, at most 4 of 10 beginners, but in at most a third of the exercises, which say that
/// they do not tell them apart. Each a line.
Result<std::vector<std::string>> gates_differences(const StudyPlan& plan, const std::string& root);

}  // namespace rhexis::cli
