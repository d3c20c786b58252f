// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/menu.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "lua/curriculum_files.hpp"
#include "lua/exercise_host.hpp"
#include "trial/places.hpp"
#include "trial/report_json.hpp"

namespace rhexis::station {
namespace {

namespace fs = std::filesystem;

/// "OSACSS 29 of 30, not completed", of the newest attempt of a person whose report is there.
std::string last_attempt(const std::string& runs, const std::string& exercise) {
    std::vector<std::string> reports;
    std::error_code failed;
    for (fs::directory_iterator at(runs, failed), end; !failed && at != end; at.increment(failed)) {
        const std::string name = at->path().filename().string();
        if (name.starts_with(exercise + "-") && fs::exists(at->path() / "report.json", failed)) {
            reports.push_back((at->path() / "report.json").string());
        }
    }
    std::sort(reports.begin(), reports.end(), [](const std::string& a, const std::string& b) {
        std::error_code ignored;
        return fs::last_write_time(a, ignored) > fs::last_write_time(b, ignored);
    });
    for (const std::string& path : reports) {
        const Result<nlohmann::json> report = read_json_file(path);
        if (report && report.value().value("surgeon", nlohmann::json()) == "person") {
            return score_line(report.value()) +
                   (report.value().value("completed", nlohmann::json()) == true ? "" : ", not completed");
        }
    }
    return "";
}

/// Lessons first, as they are taught.
std::vector<std::string> in_order(std::vector<std::string> names, const std::vector<std::string>& lessons) {
    std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
        return std::find(lessons.begin(), lessons.end(), a) < std::find(lessons.begin(), lessons.end(), b);
    });
    return names;
}

std::vector<MenuExercise> exercises_in(const std::string& root, const std::string& runs, const std::string& language,
                                       const std::vector<std::string>& lessons) {
    std::vector<MenuExercise> list;
    for (const std::string& name : in_order(curricula_in(root), lessons)) {
        const bool lesson = std::find(lessons.begin(), lessons.end(), name) != lessons.end();
        ExerciseOptions options;
        options.curriculum = root + "/curricula/" + name;
        options.root = root;
        // an exercise may have no texts in that language; an operation is none, and its parts are offered
        for (const std::string& wanted : {language.empty() ? std::string("en") : language, std::string("en")}) {
            options.set["language"] = wanted;
            const Result<ExerciseHost> host = ExerciseHost::load(options);
            if (host) {
                list.push_back({name, host.value().identity().value("title", name), host.value().objectives(),
                                host.value().levels(), lesson, last_attempt(runs, name)});
                break;
            }
        }
    }
    return list;
}

std::vector<MenuPatient> patients_in(const std::string& root) {
    std::vector<MenuPatient> list;
    std::error_code failed;
    for (fs::directory_iterator at(root + "/assets/patients", failed), end; !failed && at != end;
         at.increment(failed)) {
        const Result<nlohmann::json> patient = read_json_file(at->path().string());
        if (patient) {
            const nlohmann::json note = patient.value().value("note", nlohmann::json(""));
            list.push_back({at->path().string(),
                            note.is_string() && note != "" ? note.get<std::string>() : at->path().stem().string()});
        }
    }
    std::sort(list.begin(), list.end(), [](const MenuPatient& a, const MenuPatient& b) { return a.file < b.file; });
    return list;
}

}  // namespace

Menu collect_menu(const std::string& root, const std::string& runs, const std::string& language,
                  const std::vector<std::string>& lessons) {
    return {exercises_in(root, runs, language, lessons), patients_in(root), root, language};
}

}  // namespace rhexis::station
