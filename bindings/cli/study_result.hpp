// SPDX-License-Identifier: GPL-3.0-or-later
// What a study found: scores of groups, whether they differ, and which items tell them apart.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/study_plan.hpp"

namespace rhexis::cli {

/// One attempt: report.json of a run.
struct StudyRun {
    std::string group;
    std::uint64_t seed = 0;
    nlohmann::json report;
};

/// "surgeons": one per group and seed, with the mean score of each item over the exercises that score it and `score`,
/// 20 to 100: all items 1 point, to all items 5. "groups": n, mean, sd and range of that, "published" beside it.
/// "tests": Mann and Whitney's U between neighbouring groups and the first and last. "items": mean and sd per group, p
/// of first against last group, correlation with the rest of the score. "exercises": per group attempts, how many were
/// completed, and mean and sd of the shares of the scale of those. Errors: what operators made, not what was given.
nlohmann::json study_result(const StudyPlan& plan, const std::vector<StudyRun>& runs);

/// The same as tables in Markdown.
std::string study_text(const nlohmann::json& result);

}  // namespace rhexis::cli
