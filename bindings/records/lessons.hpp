// SPDX-License-Identifier: GPL-3.0-or-later
// Courses: lessons in an order, and what each asks before it. They are data (courses/NAME.json) and applied when
// records are read, as gates are.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "records/gates.hpp"

namespace rhexis::records {

struct Lesson {
    std::string exercise;
    std::vector<std::string> after;  ///< lessons whose gates must be open before it
};

struct LessonPlan {
    std::string name;
    std::string title;
    bool refuses = false;  ///< a closed lesson is not run; else it is, with a notice
    std::vector<Lesson> lessons;
};

/// From the JSON of a file in courses/. A lesson that says nothing asks for the one before it. Fails on names that
/// there are not, a lesson that is there twice, and one that asks for itself or a later one.
Result<LessonPlan> lessons_from(const nlohmann::json& given, const std::string& where);

struct LessonState {
    Lesson lesson;
    Course course;                       ///< of the trainee in it
    std::vector<std::string> waits_for;  ///< lessons whose gates are still closed; none: it is open
    [[nodiscard]] bool passed() const { return course.open_after > 0; }
    [[nodiscard]] bool open() const { return waits_for.empty(); }
};

/// In the order of the plan. attempts: of one trainee, finished, with events, oldest first.
std::vector<LessonState> states_of(const LessonPlan& plan, const Gates& gates, const std::vector<Attempt>& attempts);

/// The first that is open and not passed; null: all are passed.
const LessonState* next_of(const std::vector<LessonState>& states);

}  // namespace rhexis::records
