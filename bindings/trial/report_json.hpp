// SPDX-License-Identifier: GPL-3.0-or-later
// report.json: what the exercise found, with what the program knows of the run. docs/report.md describes each field.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/log.hpp"
#include "flow/eye_model.hpp"
#include "trial/pictures.hpp"

namespace rhexis {

inline constexpr int report_schema = 1;

struct ReportInput {
    nlohmann::json identity;  ///< of the curriculum
    std::string surgeon;
    std::string device;                      ///< that a person operated with: "mouse"; empty: no person did
    std::map<std::string, std::string> set;  ///< what --set changed, habits of the surgeon included
    std::uint64_t seed = 0;
    std::string start;            ///< state file that the run began from; empty: the eye at rest
    std::string begun_at;         ///< moment, state file or part that was asked for to begin at; empty: the beginning
    std::vector<double> opening;  ///< of the bag, as SceneDescription has it
    std::string opening_note;     ///< why it is not the one that was torn before; empty: nothing to say
    Patient patient;
    double duration_s = 0.0;
    std::uint64_t state_hash = 0;  ///< after the last step
    nlohmann::json result;         ///< of the exercise: completed, steps, events, osacss, measures, advice, ...
    std::string script_error;
    std::vector<Picture> pictures;
    bool video = false;
    Log log;
    nlohmann::json simulated;
    nlohmann::json performance;
};

nlohmann::json make_report(const ReportInput& input);

/// One line for the terminal: "osacss 13 of 15 (0.83)", or why there is no score.
std::string score_line(const nlohmann::json& report);

}  // namespace rhexis
