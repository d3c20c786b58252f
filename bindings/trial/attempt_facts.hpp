// SPDX-License-Identifier: GPL-3.0-or-later
// What an attempt was and came to, before it is written to any file.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/log.hpp"
#include "flow/accuracy.hpp"
#include "flow/eye_model.hpp"
#include "trial/pictures.hpp"
#include "trial/sample_link.hpp"

namespace rhexis {

/// How an attempt kept to the wall clock.
struct Pace {
    double late_p99_9_steps = 0.0;  ///< lateness that one step in a thousand exceeds, in steps
    double slowed_share = 0.0;      ///< of the clock's time, that was not caught up
    int steal_s =
        0;  ///< seconds in which other machines had more than a hundredth of the cores, and which are left out
    double pictures_per_s = 0.0;
};

/// What copies of the state for the recording cost.
struct CheckpointCost {
    int count = 0;
    double worst_taking_ms = 0.0;   ///< on the thread that steps
    double worst_writing_ms = 0.0;  ///< to encode and write one, on another
};

/// Times of the kernel's step, all threads, without scripts and pictures.
struct Performance {
    std::size_t steps = 0;
    double cpu_s_per_s = 0.0;
    double mean_step_ms = 0.0;
    double p99_step_ms = 0.0;
    double worst_step_ms = 0.0;
    long rollbacks = 0;
    CheckpointCost checkpoints;
    std::optional<Pace> live;  ///< none: there was no clock
};

/// A part of what was simulated.
struct SimulatedPart {
    std::string part;
    std::size_t elements = 0;
    double cpu_s = 0.0;
};

struct Score {
    std::string rubric;
    double total = 0.0;
    double max = 0.0;
    double scaled = 0.0;  ///< 0 to 1
};

struct AttemptFacts {
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
    SceneAccuracy accuracy;   ///< how finely it was simulated
    nlohmann::json measured;  ///< of --accuracy measure: see accuracy_measure.hpp; null: nobody asked
    double duration_s = 0.0;
    std::uint64_t state_hash = 0;  ///< after the last step
    bool completed = false;
    std::optional<Score> score;  ///< none: the exercise was not judged
    std::string script_error;    ///< the exercise ended with this; empty: it did not
    nlohmann::json findings;     ///< of the exercise's script, as it tells them: steps, events, osacss, measures, ...
    std::vector<Picture> pictures;
    bool video = false;
    Log log;
    std::vector<SimulatedPart> simulated;
    Performance performance;
    std::optional<LinkFigures> link;  ///< that hands came through; none: nothing was between
};

}  // namespace rhexis
