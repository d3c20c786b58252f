// SPDX-License-Identifier: GPL-3.0-or-later
// What a study runs: exercises, groups of virtual surgeons, seeds. Declared in studies/NAME.json.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis::cli {

struct StudyExercise {
    std::string exercise;                    ///< as for rhexis run
    std::string start;                       ///< of its starts.lua; "": its own beginning
    std::map<std::string, std::string> set;  ///< as --set of rhexis run
};

struct StudyPlan {
    std::string name;
    std::string title;
    std::vector<std::string> groups;
    std::uint64_t first_seed = 0;
    std::uint64_t last_seed = 0;
    double limit_s = 90.0;  ///< simulated time of each attempt
    std::vector<StudyExercise> exercises;
    nlohmann::json published;  ///< {"source", "groups": {"a": {"n","mean","sd"}}} to print beside; null: none
    bool reference = false;    ///< its scores become what attempts are compared with: cohorts.json
    bool gates = false;        ///< it tries the gates: gates_accepted.json
};

/// name: a file, or the bare name of one in root/studies. Names the field that is wrong, its value and what is allowed.
Result<StudyPlan> read_study(const std::string& name, const std::string& root);

}  // namespace rhexis::cli
