// SPDX-License-Identifier: GPL-3.0-or-later
// A recording judged again, by the same or another exercise script.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "lua/exercise_host.hpp"
#include "lua/operation_script.hpp"
#include "session/recording.hpp"

namespace rhexis {

struct Rescore {
    nlohmann::json identity;      ///< of the exercise that judged
    nlohmann::json result;        ///< of the exercise, as for report.json
    std::string script_error;     ///< empty: none
    std::uint64_t judged = 0;     ///< steps that the exercise saw
    std::uint64_t simulated = 0;  ///< first step that was simulated again, because its commands differ; 0: none
    std::string difference;       ///< what differed there
};

/// Shows the recorded observations to the exercise. As soon as it wants to set something else than was set, the rest is
/// simulated again with its commands and the recorded hand.
Result<Rescore> rescore(const Recording& recording, const ExerciseOptions& options);

/// What to judge a recording with. score_with: an exercise, or a rubric (see find_rubric); with a rubric, the exercise
/// is the one that was recorded.
ExerciseOptions judge_of(const Recording& recording, const std::string& score_with, const std::string& root);

/// All parts of an operation judged again, each going on where the one before it ended; as for the report.json of the
/// whole. rubric: file to judge by in place of the operation's own; empty: none. parts: their folders, in order. Where
/// a script fails, what was judged until then is the result.
Result<Rescore> rescore_operation(const Operation& operation, const std::string& rubric,
                                  const std::vector<std::string>& parts, const std::string& root);

}  // namespace rhexis
