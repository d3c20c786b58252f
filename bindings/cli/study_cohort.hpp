// SPDX-License-Identifier: GPL-3.0-or-later
// How groups of virtual surgeons did each exercise of a study, and where their scores part: what the report compares an
// attempt with.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/study_result.hpp"

namespace rhexis::cli {

/// Of one group in one exercise: all attempts, and shares of the scale of those that were completed, ascending.
struct GroupScores {
    std::string group;
    int attempts = 0;
    std::vector<double> completed;
};

/// Each exercise of a study, in the order of the plan's groups. Key: id of the exercise.
std::map<std::string, std::vector<GroupScores>> scores_by_exercise(const StudyPlan& plan,
                                                                   const std::vector<StudyRun>& runs);

/// Where the completed attempts of groups part: [{"from", "groups", "n"}], ascending in "from", the least share of the
/// scale that is like those groups. Groups part where Mann and Whitney's test tells both sides apart with p < 0.05, the
/// place with the least p first; groups that are not told apart stay together. Groups with fewer than three completed
/// attempts are left out.
nlohmann::json cuts_of(const std::vector<GroupScores>& groups);

/// rubrics/cohorts.json of a study. root: folder with curricula/.
nlohmann::json cohorts_of(const StudyPlan& plan, const std::vector<StudyRun>& runs, const std::string& root);

}  // namespace rhexis::cli
