// SPDX-License-Identifier: GPL-3.0-or-later
// report.json: what the exercise found, with what the program knows of the run. docs/report.md describes each field.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "trial/attempt_facts.hpp"

namespace rhexis {

inline constexpr int report_schema = 1;

/// Fields that are missing in what the script found have their empty values.
nlohmann::json make_report(const AttemptFacts& facts);

/// Of a report's "osacss"; none: it was not judged.
std::optional<Score> score_in(const nlohmann::json& report);

/// One line for the terminal: "osacss 13 of 15 (0.83)", or why there is no score.
std::string score_line(const std::optional<Score>& score, bool completed);
std::string score_line(const nlohmann::json& report);

}  // namespace rhexis
