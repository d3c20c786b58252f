// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/gates.hpp"

#include <algorithm>

#include "base/near_names.hpp"
#include "base/numbers.hpp"
#include "records/known_keys.hpp"

namespace rhexis::records {
namespace {

using nlohmann::json;

constexpr double most_in_a_row = 20.0;

Status take_gate(const json& given, const std::string& where, Gate& gate) {
    if (!given.is_object()) {
        return Error{"a gate is an object", where, R"({"pass": 0.8, "in_a_row": 2})"};
    }
    for (const auto& [key, value] : given.items()) {
        Status status = success();
        if (key == "pass" && value.is_number()) {
            gate.pass = value.get<double>();
            status = check_range("pass", gate.pass, 0.0, 1.0, where);
        } else if (key == "in_a_row" && value.is_number_integer()) {
            status = check_range("in_a_row", value.get<double>(), 1.0, most_in_a_row, where);
            gate.in_a_row = status ? value.get<int>() : gate.in_a_row;
        } else if (key == "no_critical_error_left" && value.is_boolean()) {
            gate.no_critical_error_left = value.get<bool>();
        } else if (key == "from_the_beginning" && value.is_boolean()) {
            gate.from_the_beginning = value.get<bool>();
        } else if (key == "mode" && (value == "exam" || value == "teaching" || value == "")) {
            gate.mode = value.get<std::string>();
        } else if (key == "reason" && value.is_string()) {
            gate.reason = value.get<std::string>();
        } else if (key == "tells_apart" && value.is_boolean()) {
            gate.tells_apart = value.get<bool>();
        } else {
            const std::vector<std::string> known = {
                "pass", "in_a_row", "no_critical_error_left", "from_the_beginning", "mode", "reason", "tells_apart"};
            status = Error{"what is " + key + " = " + value.dump() + "?", where, suggestion(key, known)};
        }
        if (!status) {
            return status;
        }
    }
    return success();
}

bool left_a_critical_error(const Attempt& attempt) {
    return std::any_of(attempt.events.begin(), attempt.events.end(),
                       [](const EventRow& event) { return event.severity == "critical" && !event.recovered; });
}

}  // namespace

const Gate& Gates::of(const std::string& exercise) const {
    const auto own = exercises.find(exercise);
    return own == exercises.end() ? usual : own->second;
}

Result<Gates> gates_from(const json& given, const std::string& where) {
    Gates gates;
    if (!given.is_object()) {
        return Error{"gates are an object", where, R"({"usual": {...}, "exercises": {...}})"};
    }
    Status status = check_keys(given, {"note", "usual", "exercises"}, where);
    if (status) {
        status = take_gate(given.value("usual", json::object()), where + ": usual", gates.usual);
    }
    const json exercises = given.value("exercises", json::object());
    if (!exercises.is_object()) {
        return Error{"exercises: their gates by their names", where, R"({"groove": {"pass": 0.8}})"};
    }
    for (const auto& [exercise, gate] : exercises.items()) {
        if (status) {
            gates.exercises[exercise] = gates.usual;
            status = take_gate(gate, where + ": " + exercise, gates.exercises[exercise]);
        }
    }
    return status ? Result<Gates>(gates) : status.error();
}

std::string why_no_pass(const Attempt& attempt, const Gate& gate) {
    if (!attempt.error.empty()) {
        return "an error of the exercise's script ended it";
    }
    if (!attempt.completed) {
        return "not completed";
    }
    if (gate.from_the_beginning && !attempt.begun_at.empty()) {
        return "it began at a later moment";
    }
    if (!attempt.aids.empty()) {
        return "with aids";
    }
    if (!gate.mode.empty() && attempt.mode != gate.mode) {
        return "in another mode than the gate asks for";
    }
    if (!attempt.scaled || *attempt.scaled < gate.pass) {
        return "below the pass mark";
    }
    return gate.no_critical_error_left && left_a_critical_error(attempt) ? "a critical error was not put right" : "";
}

bool passes(const Attempt& attempt, const Gate& gate) { return why_no_pass(attempt, gate).empty(); }

double Course::first() const { return attempts.empty() ? 0.0 : *attempts.front().scaled; }

std::optional<double> Course::peak() const {
    std::optional<double> best;
    for (const Attempt& attempt : attempts) {
        if (attempt.completed) {
            best = std::max(best.value_or(0.0), *attempt.scaled);
        }
    }
    return best;
}

Course course_of(const std::vector<Attempt>& attempts, const std::string& exercise, const Gate& gate) {
    Course course;
    double time_s = 0.0;
    for (const Attempt& attempt : attempts) {
        if (attempt.exercise != exercise || attempt.state != AttemptState::finished || !attempt.scaled) {
            continue;
        }
        course.attempts.push_back(attempt);
        course.passed.push_back(passes(attempt, gate));
        time_s += attempt.duration_s;
        course.in_a_row = course.passed.back() ? course.in_a_row + 1 : 0;
        if (course.open_after == 0 && course.in_a_row >= gate.in_a_row) {
            course.open_after = static_cast<int>(course.attempts.size());
            course.time_to_gate_s = time_s;
        }
    }
    return course;
}

}  // namespace rhexis::records
