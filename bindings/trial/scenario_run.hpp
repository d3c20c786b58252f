// SPDX-License-Identifier: GPL-3.0-or-later
// One scenario test played on a session of its own.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "lua/exercise_host.hpp"
#include "lua/scenario_script.hpp"
#include "session/session.hpp"
#include "trial/scenario_files.hpp"
#include "trial/starts.hpp"

namespace rhexis {

struct ScenarioFailure {
    std::string where;    ///< file:line
    std::string message;  ///< what was expected, what was seen
};

struct ScenarioResult {
    std::vector<ScenarioFailure> failures;
    std::string error;        ///< a script failed: "file:line: what"; empty: none did
    nlohmann::json declared;  ///< error events of the exercise: [{"id", "title"}]
    nlohmann::json covered;   ///< event id -> {"raised", "recovered", "not_recovered", "silent"}, as far as true
    nlohmann::json findings;  ///< of the exercise, as in report.json; null: there are none
    double simulated_s = 0.0;
    double cpu_s = 0.0;
    [[nodiscard]] bool passed() const { return failures.empty() && error.empty(); }
};

/// Leads the instruments of a session as the function of a start says; the session comes back as that left it.
Result<Session> play_start(ExerciseHost host, Session session, ScenarioScript script, const std::string& start);

/// What is wrong with the declaration of a scenario, without simulating: the values that it sets, its start.
Status check_scenario(const ScenarioFile& file, const nlohmann::json& scenario, const std::string& root);

/// What a scenario starts from, if it names a start; a state file may lie beside its file.
StartRequest start_of(const ScenarioFile& file, const nlohmann::json& scenario, const std::string& root);

/// The `set` of a scenario.
std::map<std::string, std::string> settings_of(const nlohmann::json& scenario);

/// number: from 0.
ScenarioResult run_scenario(const ScenarioFile& file, std::size_t number, const Start& start, const std::string& root);

}  // namespace rhexis
