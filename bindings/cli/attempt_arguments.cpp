// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/attempt_arguments.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "base/numbers.hpp"
#include "cli/language.hpp"
#include "cli/run_folder.hpp"
#include "eye/patient.hpp"
#include "trial/accuracy_notes.hpp"
#include "trial/report_json.hpp"

namespace rhexis::cli {
namespace {

constexpr double shortest_limit = 0.1;  // [s] simulated
constexpr double longest_limit = 7200.0;

/// runs/groove-expert-1, or of a trainee runs/groove-P07-20260301-093000, from the last part of the curriculum's path.
std::string default_folder(const AttemptArguments& given) {
    const std::string name = exercise_name(given.curriculum);
    return "runs/" + (given.keep.trainee.empty() ? name + "-" + given.surgeon + "-" + std::to_string(given.seed)
                                                 : folder_name_of(name, given.keep.trainee));
}

/// What the exercise began with, and whether it was put right: "Iris prolapse (put right)".
void print_given(const nlohmann::json& report) {
    std::string list;
    for (const nlohmann::json& event : report["events"]) {
        if (event.value("given", false)) {
            list += (list.empty() ? "" : ", ") + event["title"].get<std::string>() +
                    (event.value("recovered", false) ? " (put right)" : " (not put right)");
        }
    }
    if (!list.empty()) {
        std::printf("  given      %s\n", list.c_str());
    }
}

}  // namespace

std::string exercise_name(const std::string& curriculum) {
    std::filesystem::path path(curriculum);
    if (path.extension() == ".lua" && path.has_parent_path() && path.stem() == "curriculum") {
        path = path.parent_path();
    }
    const std::string name = path.has_filename() ? path.stem().string() : path.parent_path().filename().string();
    return name.empty() ? "exercise" : name;
}

void add_attempt_arguments(CLI::App& command, AttemptArguments& given) {
    command.add_option("--seed", given.seed, "Seed of all chance in the run")->capture_default_str();
    command.add_option("--patient", given.patient, "Patient file (JSON), as in assets/patients/");
    command.add_option("--start", given.start, "Begin in a state: a file, or a name in the exercise's starts.lua");
    command.add_option("--opening", given.opening,
                       "Of the bag that an implant is laid into: where it was torn. A state, a recording or the folder "
                       "of a run of a capsulorhexis, or EXERCISE:START");
    command.add_option("--out", given.out, "Folder for everything [runs/CURRICULUM-SURGEON-SEED]");
    command.add_option("--set", given.set, "Change a value: patient.*, goal.*, or a setting (repeatable)")
        ->take_all()
        ->allow_extra_args(false);
    command.add_option("--level", given.level, "Difficulty: one of the exercise's levels");
    command.add_option("--mode", given.mode, "teaching: hints and advice are said; exam: none [as the exercise says]")
        ->check(CLI::IsMember({"teaching", "exam"}));
    command.add_option("--eye", given.eye, "Which eye of the patient [as the exercise says]")
        ->check(CLI::IsMember({"right", "left"}));
    command.add_option("--hand", given.hand, "Of the surgeon, for the main instrument [as the exercise says]")
        ->check(CLI::IsMember({"right", "left"}));
    command.add_option("--language", given.language, language_help);
    command.add_option("--threads", given.threads, "Threads; the result does not depend on it")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    add_instruction_set(command, given.instruction_set);
    command.add_option("--trainee", given.keep.trainee, "Store the attempt under this pseudonym [nothing is stored]");
    command.add_option("--cohort", given.keep.cohort, "Of the trainee [as before]");
    command.add_option("--arm", given.keep.arm, "Of the trainee, in a trial [as before]");
    command.add_option("--course", given.keep.course,
                       "Course of the trainee, whose closed lessons are told [RHEXIS_COURSE, or none]");
    command.add_option("--records", given.keep.store,
                       "File to store in [RHEXIS_RECORDS, or rhexis/records.db in the user's data folder]");
    command.add_option("--limit", given.limit_s, "End the run at this simulated time [s]")->capture_default_str();
}

Status check_attempt_arguments(const AttemptArguments& given) {
    const Status status = check_range("--limit", given.limit_s, shortest_limit, longest_limit);
    return status ? check_keep_options(given.keep) : status;
}

Result<std::map<std::string, std::string>> given_settings(const AttemptArguments& given, const std::string& root) {
    std::map<std::string, std::string> set;
    if (!given.patient.empty()) {
        const Result<Patient> patient = read_patient(given.patient);
        if (!patient) {
            return patient.error();
        }
        set["patient.age"] = short_number(patient.value().age);
        set["patient.nuclear_grade"] = short_number(patient.value().nuclear_grade);
        set["patient.cortical_opacity"] = short_number(patient.value().cortical_opacity);
        set["patient.pupil_mm"] = short_number(patient.value().pupil_mm);
        set["patient.side"] = patient.value().side;
        set["patient.tetrahedra"] = std::to_string(patient.value().tetrahedra);
    }
    for (const std::string& pair : given.set) {
        Result<std::pair<std::string, std::string>> given_one = key_and_value(pair, "run", "patient.age=80");
        if (!given_one) {
            return given_one.error();
        }
        set.insert_or_assign(given_one.value().first, given_one.value().second);
    }
    for (const auto& [name, value] :
         {std::pair("level", given.level), std::pair("mode", given.mode), std::pair("patient.side", given.eye),
          std::pair("handedness", given.hand),
          std::pair("language", given.language.empty() ? language_of_environment(root) : given.language)}) {
        if (!value.empty()) {
            set.insert_or_assign(name, value);
        }
    }
    return set;
}

AttemptOptions attempt_options(const AttemptArguments& given, std::map<std::string, std::string> set,
                               const std::string& root) {
    AttemptOptions options;
    options.exercise = {given.curriculum, given.surgeon, given.seed, std::move(set), root};
    options.folder = given.out.empty() ? default_folder(given) : given.out;
    options.threads = given.threads;
    options.instruction_set = given.instruction_set;
    options.limit_s = given.limit_s;
    return options;
}

Status check_folder(const std::string& folder, bool resume) {
    std::error_code ignored;
    const bool of_a_trainee = std::filesystem::exists(folder + "/" + note_file, ignored);
    const std::vector<std::string> results = {"/report.json", "/recording.rhx", "/recording.rhx.part", "/parts"};
    const bool holds_a_run = std::any_of(results.begin(), results.end(), [&folder, &ignored](const std::string& name) {
        return std::filesystem::exists(folder + name, ignored);
    });
    return folder.empty() || resume || !of_a_trainee || !holds_a_run
               ? success()
               : Status(Error{"an attempt of a trainee lies in this folder already", folder,
                              "another --out, or none: each attempt has a folder of its own then"});
}

Result<KeptAttempt> begin_kept(const AttemptArguments& given, const AttemptOptions& options, bool resume) {
    if (given.keep.trainee.empty()) {
        return KeptAttempt::begin(given.keep, {}, "", 0, "", false);
    }
    const Result<ExerciseHost> host = ExerciseHost::load(options.exercise);
    return host ? KeptAttempt::begin(given.keep, host.value().identity(), given.surgeon, given.seed, options.folder,
                                     resume)
                : host.error();
}

void print_objectives(const nlohmann::json& report) {
    for (const nlohmann::json& objective : report.value("objectives", nlohmann::json::array())) {
        std::printf("  objective  %s\n", objective.get<std::string>().c_str());
    }
}

/// How many were made, and which: "3: Iris touched (2), Surge". What the exercise began with is none.
void print_errors(const nlohmann::json& report) {
    std::vector<std::pair<std::string, int>> counts;
    int made = 0;
    for (const nlohmann::json& event : report["events"]) {
        if (event.value("given", false)) {
            continue;
        }
        ++made;
        const std::string title = event["title"];
        const auto known =
            std::find_if(counts.begin(), counts.end(), [&](const auto& one) { return one.first == title; });
        if (known == counts.end()) {
            counts.emplace_back(title, 1);
        } else {
            ++known->second;
        }
    }
    std::string list;
    for (const auto& [title, count] : counts) {
        list += (list.empty() ? ": " : ", ") + title + (count > 1 ? " (" + std::to_string(count) + ")" : "");
    }
    print_given(report);
    std::printf("  errors     %d%s\n", made, list.c_str());
}

void print_summary(const AttemptArguments& given, const std::string& who, const std::string& folder,
                   const AttemptResult& result) {
    const AttemptFacts& facts = result.facts;
    std::printf("%s by %s, seed %llu: %s after %.1f s\n", given.curriculum.c_str(), who.c_str(),
                static_cast<unsigned long long>(given.seed), facts.completed ? "completed" : "not completed",
                facts.duration_s);
    print_objectives(facts.findings);
    std::printf("  score      %s\n", score_line(facts.score, facts.completed).c_str());
    print_errors(facts.findings);
    if (facts.link) {
        std::printf("  hands      %s: %.0f um off (RMS), at most %.0f um; %lld of %lld samples not seen\n",
                    facts.link->name.c_str(), 1e3 * facts.link->rms_mm, 1e3 * facts.link->farthest_mm,
                    static_cast<long long>(facts.link->unseen), static_cast<long long>(facts.link->present));
    }
    if (result.html_error.empty()) {
        std::printf("  report     %s/report.html\n", folder.c_str());
    }
    std::printf("  numbers    %s/report.json\n", folder.c_str());
    if (!facts.pictures.empty()) {
        std::printf("  pictures   %s/frames/ (%zu)\n", folder.c_str(), facts.pictures.size());
    }
    if (facts.video) {
        std::printf("  video      %s/video.mp4\n", folder.c_str());
    }
    std::printf("  recording  %s\n", result.recording.c_str());
    std::printf("  cost       %.2f s of CPU per simulated second\n", facts.performance.cpu_s_per_s);
    if (facts.measured.is_object()) {
        std::printf("  accuracy   %s\n", measured_line(facts.measured).c_str());
    }
}

}  // namespace rhexis::cli
