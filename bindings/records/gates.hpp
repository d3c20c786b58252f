// SPDX-License-Identifier: GPL-3.0-or-later
// Gates: how good an attempt must be, and how often in a row, before a trainee goes on. They are data
// (rubrics/gates.json) and applied when records are read, so that a gate can be changed later.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "records/attempt.hpp"

namespace rhexis::records {

struct Gate {
    double pass = 0.75;                  ///< least share of the scale: 0: every item at its least, 1: at its most
    int in_a_row = 2;                    ///< passes that open the gate
    bool no_critical_error_left = true;  ///< an attempt with a critical error that was not put right is no pass
    bool from_the_beginning = true;      ///< an attempt that began at a later moment is no pass
    std::string mode;                    ///< "exam" or "teaching": attempts in another are no pass; "": any
    std::string reason;                  ///< why the pass mark is where it is
    bool tells_apart = true;             ///< false: the exercise tells no beginner from an expert
};

struct Gates {
    Gate usual;
    std::map<std::string, Gate> exercises;  ///< that have one of their own

    [[nodiscard]] const Gate& of(const std::string& exercise) const;
};

/// From the JSON of rubrics/gates.json; fails on names that there are not and on numbers that make no sense.
Result<Gates> gates_from(const nlohmann::json& given, const std::string& where);

/// Why an attempt is no pass, in words that scripts/texts translate; "": it is one. Needs the attempt's events.
std::string why_no_pass(const Attempt& attempt, const Gate& gate);

/// Whether it was completed and scored well enough.
bool passes(const Attempt& attempt, const Gate& gate);

/// How a trainee came along in one exercise.
struct Course {
    std::vector<Attempt> attempts;  ///< finished and scored, oldest first
    std::vector<bool> passed;
    int open_after = 0;           ///< attempts until the gate opened; 0: it has not
    double time_to_gate_s = 0.0;  ///< simulated time of these attempts
    int in_a_row = 0;             ///< passes at the end of the list

    [[nodiscard]] double first() const;                ///< share of the scale
    [[nodiscard]] std::optional<double> peak() const;  ///< the best that was completed
};

/// attempts: of one trainee, oldest first, with events; those of other exercises and without a score are left out.
Course course_of(const std::vector<Attempt>& attempts, const std::string& exercise, const Gate& gate);

}  // namespace rhexis::records
