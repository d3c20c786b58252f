// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/course_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/near_names.hpp"
#include "lua/curriculum_files.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {

Result<records::LessonPlan> read_course(const std::string& name, const std::string& root) {
    const Result<std::string> path = find_json_file("course", name, root + "/courses");
    const Result<std::string> text = path ? read_whole_file(path.value()) : path;
    if (!text) {
        return text.error();
    }
    const nlohmann::json given = nlohmann::json::parse(text.value(), nullptr, false);
    if (given.is_discarded()) {
        return Error{"this is no JSON", path.value(), "a course as courses/cataract.json"};
    }
    Result<records::LessonPlan> plan = records::lessons_from(given, path.value());
    if (!plan) {
        return plan;
    }
    plan.value().name = std::filesystem::path(path.value()).stem().string();
    const std::vector<std::string> known = curricula_in(root);
    for (const records::Lesson& lesson : plan.value().lessons) {
        if (std::find(known.begin(), known.end(), lesson.exercise) == known.end()) {
            return Error{"there is no exercise '" + lesson.exercise + "'", path.value(),
                         suggestion(lesson.exercise, known)};
        }
    }
    return plan;
}

std::string course_named(const std::string& given) {
    const char* named = std::getenv("RHEXIS_COURSE");
    return !given.empty() || named == nullptr ? given : named;
}

Result<records::LessonPlan> read_course_or_usual(const std::string& given, const std::string& root) {
    const std::string named = course_named(given);
    return read_course(named.empty() ? "cataract" : named, root);
}

}  // namespace rhexis::cli
