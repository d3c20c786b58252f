// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/course_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/near_names.hpp"
#include "cli/places.hpp"
#include "lua/curriculum_files.hpp"

namespace rhexis::cli {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> courses_in(const std::string& root) {
    std::vector<std::string> names;
    std::error_code failed;
    for (fs::directory_iterator at(root + "/courses", failed), end; !failed && at != end; at.increment(failed)) {
        if (at->path().extension() == ".json") {
            names.push_back(at->path().stem().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

Result<std::string> path_of(const std::string& name, const std::string& root) {
    std::error_code ignored;
    for (const std::string& path : {name, root + "/courses/" + name + ".json"}) {
        if (fs::is_regular_file(path, ignored)) {
            return path;
        }
    }
    return Error{"there is no course '" + name + "'", "", suggestion(name, courses_in(root))};
}

}  // namespace

Result<records::LessonPlan> read_course(const std::string& name, const std::string& root) {
    const Result<std::string> path = path_of(name, root);
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
    plan.value().name = fs::path(path.value()).stem().string();
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

}  // namespace rhexis::cli
