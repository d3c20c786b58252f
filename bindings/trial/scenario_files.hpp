// SPDX-License-Identifier: GPL-3.0-or-later
// Where scenario tests lie, and what they declare.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis {

struct ScenarioFile {
    std::string path;
    std::string chunk;         ///< its name in messages of Lua
    std::string curriculum;    ///< of the exercise that it tests, as ExerciseOptions has it
    std::string exercise;      ///< id of that exercise
    nlohmann::json scenarios;  ///< [{"name", "line", "seed", "set", "start", "silent_twin_of"}]
};

/// The scenario files that a path stands for: itself, those in a folder and below it (tests/*.lua, *_test.lua), or
/// those of a bare name in curricula/. Sorted; fails when there are none.
Result<std::vector<std::string>> scenario_paths(const std::string& given, const std::string& root);

/// The scenario files in a folder and below it, sorted; maybe none.
std::vector<std::string> scenarios_below(const std::string& folder);

/// Reads a file and finds its exercise: the one that it names, or the one in whose folder it lies.
Result<ScenarioFile> read_scenarios(const std::string& path, const std::string& root);

/// `where` with the chunk of the file replaced by its path, so that editors find it.
std::string place_in_file(const ScenarioFile& file, const std::string& where);

}  // namespace rhexis
