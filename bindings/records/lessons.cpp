// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/lessons.hpp"

#include <algorithm>

#include "base/near_names.hpp"
#include "records/known_keys.hpp"

namespace rhexis::records {
namespace {

using nlohmann::json;

constexpr const char* form =
    R"({"title": "...", "closed": "notice", "lessons": [{"exercise": "groove", "after": ["navigation"]}]})";

Status take_after(const json& given, const std::vector<std::string>& before, const std::string& where, Lesson& lesson) {
    if (!given.is_array()) {
        return Error{"after: a list of lessons", where, R"(["navigation"])"};
    }
    lesson.after.clear();
    for (const json& name : given) {
        if (!name.is_string() || std::find(before.begin(), before.end(), name) == before.end()) {
            const std::string text = name.is_string() ? name.get<std::string>() : name.dump();
            return Error{"after: there is no lesson '" + text + "' before it", where, suggestion(text, before)};
        }
        lesson.after.push_back(name);
    }
    return success();
}

Status take_lesson(const json& given, const std::string& where, LessonPlan& plan) {
    if (!given.is_object() || !given.contains("exercise") || !given["exercise"].is_string()) {
        return Error{"a lesson is an object with an exercise", where, R"({"exercise": "groove"})"};
    }
    Status status = check_keys(given, {"exercise", "after"}, where);
    if (!status) {
        return status;
    }
    std::vector<std::string> before;
    for (const Lesson& lesson : plan.lessons) {
        before.push_back(lesson.exercise);
    }
    Lesson lesson{given["exercise"], {}};
    if (std::find(before.begin(), before.end(), lesson.exercise) != before.end()) {
        return Error{lesson.exercise + " is there twice", where, "each once"};
    }
    if (!before.empty()) {
        lesson.after = {before.back()};
    }
    if (given.contains("after")) {
        status = take_after(given["after"], before, where, lesson);
    }
    plan.lessons.push_back(std::move(lesson));
    return status;
}

}  // namespace

Result<LessonPlan> lessons_from(const json& given, const std::string& where) {
    if (!given.is_object()) {
        return Error{"a course is an object", where, form};
    }
    Status status = check_keys(given, {"note", "title", "closed", "lessons"}, where);
    if (!status) {
        return status.error();
    }
    LessonPlan plan;
    const json title = given.value("title", json(""));
    const json closed = given.value("closed", json("notice"));
    const json lessons = given.value("lessons", json());
    if (!title.is_string() || (closed != "notice" && closed != "refuse")) {
        return Error{"title is a text, and closed is notice or refuse", where, form};
    }
    if (!lessons.is_array() || lessons.empty()) {
        return Error{"a course has a list of lessons", where, form};
    }
    plan.title = title;
    plan.refuses = closed == "refuse";
    for (std::size_t i = 0; i < lessons.size() && status; ++i) {
        status = take_lesson(lessons[i], where + ": lesson " + std::to_string(i + 1), plan);
    }
    return status ? Result<LessonPlan>(std::move(plan)) : status.error();
}

std::vector<LessonState> states_of(const LessonPlan& plan, const Gates& gates, const std::vector<Attempt>& attempts) {
    std::vector<LessonState> states;
    for (const Lesson& lesson : plan.lessons) {
        LessonState state{lesson, course_of(attempts, lesson.exercise, gates.of(lesson.exercise)), {}};
        for (const std::string& name : lesson.after) {
            const auto asked = std::find_if(states.begin(), states.end(),
                                            [&name](const LessonState& one) { return one.lesson.exercise == name; });
            if (!asked->passed()) {
                state.waits_for.push_back(name);
            }
        }
        states.push_back(std::move(state));
    }
    return states;
}

const LessonState* next_of(const std::vector<LessonState>& states) {
    const auto found = std::find_if(states.begin(), states.end(),
                                    [](const LessonState& state) { return state.open() && !state.passed(); });
    return found == states.end() ? nullptr : &*found;
}

}  // namespace rhexis::records
