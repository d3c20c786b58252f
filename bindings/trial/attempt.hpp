// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt at an exercise: session, exercise and surgeon side by side, with recorder, pictures and report.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "lua/exercise_host.hpp"
#include "trial/attempt_facts.hpp"
#include "trial/going_on.hpp"
#include "trial/sample_link.hpp"
#include "trial/starts.hpp"
#include "trial/state_keeper.hpp"

namespace rhexis {

enum class Drawing {
    if_possible,  ///< pictures where there is a device to draw with
    none,
    video,  ///< pictures and a video, or no run
};

/// Somebody from outside who operates in place of a virtual surgeon: a person at the station. The microscope is in the
/// scene of such an attempt.
class Guest : public Operator, public TrialObserver {
public:
    /// Before the trial begins: what there is to be known of the exercise.
    virtual void meet(ExerciseHost& host) = 0;
    /// As report and recording call whoever operated: "person".
    [[nodiscard]] virtual std::string name() const = 0;
    /// With which device: "mouse", "gamepad", "vrpn".
    [[nodiscard]] virtual std::string device() const = 0;
    /// How it kept to the wall clock; none: there was none.
    [[nodiscard]] virtual std::optional<Pace> pace() const { return std::nullopt; }
    /// Asked when the trial has ended: the step to go on from instead; none: it was the end.
    virtual std::optional<std::uint64_t> goes_back() { return std::nullopt; }
};

struct AttemptOptions {
    ExerciseOptions exercise;
    std::string folder;  ///< receives everything
    int threads = 1;
    std::string instruction_set;  ///< as SceneDescription has it
    Start start;
    SaveOptions save;
    Drawing drawing = Drawing::if_possible;
    double limit_s = 600.0;  ///< simulated time after which the run ends whatever the exercise says
    bool quiet = false;      ///< no progress
    nlohmann::json comparison = nlohmann::json::object();  ///< fields to add to the report: "history", "cohort"
    const GoingOn* going_on = nullptr;                     ///< outlives the attempt; null: it begins
    Guest* guest = nullptr;                                ///< null: the virtual surgeon of the exercise, or nobody
    SampleLink* link = nullptr;                            ///< that hands go through; null: none
    bool measure_accuracy = false;  ///< afterwards it is simulated again at twice the resolution: accuracy_measure.hpp
    bool watch = false;             ///< the exercise is read again between two steps when its files have changed
};

struct AttemptResult {
    AttemptFacts facts;
    nlohmann::json comparison;  ///< as the options had it
    nlohmann::json operation;   ///< of a part: the operation as far as it has come, see ExerciseHost::result
    std::string drawing_note;   ///< why there are no pictures; empty: there are
    std::string recording;      ///< path
    std::string html_error;     ///< why there is no report.html; empty: there is one
    bool saved = false;         ///< the state that was to be kept is
};

/// As written to report.json.
nlohmann::json report_of(const AttemptResult& result);

/// Runs the exercise to its end and leaves everything in the folder. An error means bad input or a disk that cannot be
/// written; a recording that was begun stays, readable to its last whole step.
Result<AttemptResult> attempt(const AttemptOptions& options);

}  // namespace rhexis
