// SPDX-License-Identifier: GPL-3.0-or-later
// What the store keeps of one attempt at an exercise. docs/records.md describes the tables.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rhexis::records {

/// A trainee is known by a pseudonym only; who that is stays with the centre.
struct Trainee {
    std::string pseudonym;
    std::string cohort;  ///< "" when none was named
    std::string arm;     ///< of a trial: the group that the trainee was allotted to; "" when none was named
};

struct ItemScore {
    std::string id;
    std::string name;
    std::optional<double> score;  ///< none: not observed in this attempt
    std::string capped_by;        ///< ids of events, with blanks between
};

struct MeasureValue {
    std::string id;
    std::string name;
    std::optional<double> value;
    std::string unit;
    std::optional<double> score;
};

struct EventRow {
    double time_s = 0.0;
    std::string step;
    std::string id;
    std::string severity;
    bool recovered = false;
    std::optional<double> recovery_s;  ///< from the event to its recovery
};

enum class AttemptState {
    running,      ///< begun, and its process lives
    interrupted,  ///< begun, and its process is gone: the recording ends where that was killed
    finished,
};

struct Attempt {
    std::string id;  ///< UUID
    Trainee trainee;
    std::string exercise;
    std::string title;
    double version = 0.0;
    std::string sha256;  ///< of the exercise's scripts
    std::string surgeon;
    std::uint64_t seed = 0;
    std::string begun;    ///< UTC, ISO 8601
    std::string process;  ///< see process_mark
    std::string folder;   ///< of the run, absolute
    AttemptState state = AttemptState::running;

    // Known once it is finished.
    std::string ended;
    bool completed = false;
    double duration_s = 0.0;  ///< simulated
    std::string patient;      ///< JSON
    std::string settings;     ///< JSON: what --set and the like changed
    std::string level;
    std::string mode;
    std::string language;
    std::string rubric;
    std::optional<double> total;
    std::optional<double> max;
    std::optional<double> scaled;  ///< 0: every item at its least, 1: at its most
    std::string begun_at;          ///< moment, state file or part that it began at; "": the beginning
    std::string input;             ///< device that a person operated with: "mouse", "gamepad"; "": no person did
    std::string aids;              ///< ids of those that were given, with blanks between; "": none
    std::string error;             ///< of the exercise's script; "": none
    std::string recording_sha256;
    std::vector<ItemScore> items;
    std::vector<MeasureValue> measures;
    std::vector<EventRow> events;
};

/// One rater's answers about one attempt.
struct RatedItem {
    std::string id;
    std::optional<int> score;  ///< 1 to 5; none: not applicable
    std::string comment;
};

struct Rating {
    std::string attempt;  ///< id
    std::string rater;    ///< pseudonym
    std::string rated;    ///< UTC, ISO 8601
    std::string comment;
    std::vector<RatedItem> items;
};

}  // namespace rhexis::records
