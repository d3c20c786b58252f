// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis run: one attempt at an exercise, by a virtual surgeon or by nobody.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <utility>
#include <vector>

#include "base/folder_lock.hpp"
#include "base/numbers.hpp"
#include "cli/command.hpp"
#include "cli/kept_attempt.hpp"
#include "cli/language.hpp"
#include "cli/run_folder.hpp"
#include "eye/patient.hpp"
#include "trial/attempt.hpp"
#include "trial/operation.hpp"
#include "trial/report_json.hpp"
#include "trial/starts.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* run_help =
    "Runs an exercise without a window and leaves report, pictures and recording in a folder.\n"
    "\n"
    "  rhexis run groove\n"
    "  rhexis run groove --surgeon novice --seed 7 --video --out runs/novice-7\n"
    "  rhexis run groove --set patient.age=80 --set phaco.power_limit=0.6\n"
    "  rhexis run my_exercise/ --surgeon none --json > report.json\n"
    "  rhexis run groove --save-state \"half.rhxs@groove.depth_share > 0.3\"\n"
    "  rhexis run groove --surgeon novice --start half.rhxs\n"
    "  rhexis run iol_injection --opening runs/capsulorhexis-expert-101\n"
    "  rhexis run full_operation                  all its parts, one after the other\n"
    "  rhexis run full_operation --from capsulorhexis --to capsulorhexis\n"
    "  rhexis run full_operation --resume         without the parts that are there already\n"
    "  rhexis run groove --trainee P07 --cohort 2026    the attempt is stored; see rhexis records --help\n"
    "\n"
    "Without a device to draw with the run goes on without pictures and says so; with --video it does not start.\n"
    "Without --trainee nothing is stored but the run's own folder.";

constexpr double shortest_limit = 0.1;  // [s] simulated
constexpr double longest_limit = 7200.0;

struct RunOptions {
    std::string curriculum;
    std::string surgeon = "expert";
    std::uint64_t seed = 1;
    std::string patient;
    std::string out;
    std::string start;
    std::string opening;
    std::string save_state;
    bool json = false;
    bool video = false;
    bool no_pictures = false;
    std::vector<std::string> set;
    int threads = 1;
    std::string instruction_set;
    double limit_s = 600.0;
    std::string from;
    std::string to;
    bool resume = false;
    std::string level;
    std::string mode;
    std::string eye;
    std::string hand;
    std::string language;
    bool watch = false;
    KeepOptions keep;
};

Result<std::map<std::string, std::string>> given_settings(const RunOptions& given, const std::string& root) {
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

/// FILE, FILE@SECONDS or FILE@CONDITION.
Result<SaveOptions> save_options_of(const std::string& given) {
    SaveOptions save;
    const std::size_t at = given.rfind('@');
    save.path = given.substr(0, at);
    if (at == std::string::npos) {
        return save;
    }
    const std::string moment = given.substr(at + 1);
    if (save.path.empty() || moment.empty()) {
        return Error{"--save-state " + given + " lacks its file or moment", "run",
                     "FILE, FILE@SECONDS, or FILE@CONDITION, as in after.rhxs@12.5"};
    }
    char* end = nullptr;
    const double seconds = std::strtod(moment.c_str(), &end);
    if (*end != '\0') {
        save.when = moment;
        return save;
    }
    save.at_s = seconds;
    const Status range = check_range("--save-state: time", seconds, 0.0, longest_limit);
    return range ? Result<SaveOptions>(save) : range.error();
}

/// runs/groove-expert-1, or of a trainee runs/groove-P07-20260301-093000, from the last part of the curriculum's path.
std::string default_folder(const RunOptions& given) {
    std::filesystem::path path(given.curriculum);
    if (path.extension() == ".lua" && path.has_parent_path() && path.stem() == "curriculum") {
        path = path.parent_path();
    }
    std::string name = path.has_filename() ? path.stem().string() : path.parent_path().filename().string();
    name = name.empty() ? "exercise" : name;
    return "runs/" + (given.keep.trainee.empty() ? name + "-" + given.surgeon + "-" + std::to_string(given.seed)
                                                 : folder_name_of(name, given.keep.trainee));
}

void print_objectives(const nlohmann::json& report) {
    for (const nlohmann::json& objective : report.value("objectives", nlohmann::json::array())) {
        std::printf("  objective  %s\n", objective.get<std::string>().c_str());
    }
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

void print_summary(const RunOptions& given, const std::string& folder, const AttemptResult& result) {
    const nlohmann::json& report = result.report;
    std::printf("%s by %s, seed %llu: %s after %.1f s\n", given.curriculum.c_str(), given.surgeon.c_str(),
                static_cast<unsigned long long>(given.seed),
                report["completed"] == true ? "completed" : "not completed", report["duration_s"].get<double>());
    print_objectives(report);
    std::printf("  score      %s\n", score_line(report).c_str());
    print_errors(report);
    if (result.html_error.empty()) {
        std::printf("  report     %s/report.html\n", folder.c_str());
    }
    std::printf("  numbers    %s/report.json\n", folder.c_str());
    if (!report["pictures"].empty()) {
        std::printf("  pictures   %s/frames/ (%zu)\n", folder.c_str(), report["pictures"].size());
    }
    if (report["video"].is_string()) {
        std::printf("  video      %s/video.mp4\n", folder.c_str());
    }
    std::printf("  recording  %s\n", result.recording.c_str());
    if (result.saved) {
        std::printf("  state      %s\n", save_options_of(given.save_state).value().path.c_str());
    }
    std::printf("  cost       %.2f s of CPU per simulated second\n",
                report["performance"]["cpu_s_per_s"].get<double>());
}

void print_parts(const nlohmann::json& report) {
    for (const nlohmann::json& part : report["parts"]) {
        std::printf("  %-22s %s after %.1f s: %s\n", part["id"].get<std::string>().c_str(),
                    part["completed"] == true ? "completed" : "not completed", part["duration_s"].get<double>(),
                    part["score"].get<std::string>().c_str());
    }
    for (const nlohmann::json& title : report.value("not_begun", nlohmann::json::array())) {
        std::printf("  %-22s not begun\n", title.get<std::string>().c_str());
    }
}

void print_whole(const RunOptions& given, const std::string& folder, const OperationResult& result) {
    const nlohmann::json& report = result.report;
    std::printf("%s by %s, seed %llu: %s after %.1f s\n", given.curriculum.c_str(), given.surgeon.c_str(),
                static_cast<unsigned long long>(given.seed),
                report["completed"] == true ? "completed" : "not completed", report["duration_s"].get<double>());
    print_objectives(report);
    print_parts(report);
    std::printf("  score      %s\n", score_line(report).c_str());
    print_errors(report);
    if (result.html_error.empty()) {
        std::printf("  report     %s/report.html\n", folder.c_str());
    }
    std::printf("  numbers    %s/report.json\n", folder.c_str());
    std::printf("  parts      %s/parts/\n", folder.c_str());
    std::printf("  cost       %.2f s of CPU per simulated second\n",
                report["performance"]["cpu_s_per_s"].get<double>());
}

/// What an operation has no use for: it begins with its first part, and its parts say where they begin.
Status check_whole(const RunOptions& given) {
    for (const auto& [option, value] : {std::pair("--start", given.start), std::pair("--opening", given.opening),
                                        std::pair("--save-state", given.save_state)}) {
        if (!value.empty()) {
            return Error{std::string(option) + " is for exercises, and " + given.curriculum + " is an operation", "",
                         "--from PART and --to PART"};
        }
    }
    return success();
}

int run_whole(const RunOptions& given, const Operation& operation, AttemptOptions attempt) {
    if (const Status status = check_whole(given); !status) {
        return complain(status.error());
    }
    attempt.quiet = given.json;
    Result<KeptAttempt> kept =
        KeptAttempt::begin(given.keep, operation.identity, given.surgeon, given.seed, attempt.folder, given.resume);
    if (!kept) {
        return complain(kept.error());
    }
    attempt.comparison = kept.value().comparison();
    const OperationOptions options{operation, std::move(attempt), given.from, given.to, given.resume};
    const Result<OperationResult> result = operate(options);
    if (!result) {
        kept.value().give_up();
        return complain(result.error());
    }
    const Status stored = kept.value().finish(result.value().report);
    if (!result.value().drawing_note.empty()) {
        std::fprintf(stderr, "rhexis: no pictures: %s\n", result.value().drawing_note.c_str());
    }
    if (given.json) {
        std::cout << result.value().report.dump(2) << '\n';
    } else {
        print_whole(given, options.attempt.folder, result.value());
    }
    if (!stored) {
        return complain(stored.error());
    }
    if (!result.value().script_error.empty()) {
        return complain({result.value().script_error, "", "the operation ended there; its recordings are kept"},
                        found_failures);
    }
    return result.value().html_error.empty() ? done
                                             : complain({"no report.html: " + result.value().html_error, "", ""});
}

/// What holds for an exercise and for every part of an operation.
AttemptOptions attempt_options(const RunOptions& given, std::map<std::string, std::string> set,
                               const Context& context) {
    AttemptOptions options;
    options.exercise = {given.curriculum, given.surgeon, given.seed, std::move(set), context.root};
    options.folder = given.out.empty() ? default_folder(given) : given.out;
    options.threads = given.threads;
    options.instruction_set = given.instruction_set;
    options.limit_s = given.limit_s;
    options.watch = given.watch;
    options.drawing = given.video ? Drawing::video : given.no_pictures ? Drawing::none : Drawing::if_possible;
    return options;
}

/// A trainee's attempt is not written over: the store names its folder.
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

/// The exercise is loaded first, so that its mistakes show before anything is stored.
Result<KeptAttempt> begin_kept(const RunOptions& given, const AttemptOptions& options) {
    if (given.keep.trainee.empty()) {
        return KeptAttempt::begin(given.keep, {}, "", 0, "", false);
    }
    const Result<ExerciseHost> host = ExerciseHost::load(options.exercise);
    return host ? KeptAttempt::begin(given.keep, host.value().identity(), given.surgeon, given.seed, options.folder,
                                     false)
                : host.error();
}

int run(RunOptions given, const Context& context) {
    given.keep.root = context.root;
    Status status = check_range("--limit", given.limit_s, shortest_limit, longest_limit);
    status = status ? check_keep_options(given.keep) : status;
    if (!status) {
        return complain(status.error());
    }
    Result<std::map<std::string, std::string>> set = given_settings(given, context.root);
    if (!set) {
        return complain(set.error());
    }
    const Result<std::optional<Operation>> operation = load_operation(
        given.curriculum, context.root, set.value().contains("language") ? set.value().at("language") : "");
    if (!operation) {
        return complain(operation.error());
    }
    status = check_folder(given.out, given.resume);
    if (!status) {
        return complain(status.error());
    }
    if (operation.value()) {
        AttemptOptions whole = attempt_options(given, std::move(set).value(), context);
        const Result<FolderLock> lock = FolderLock::take(whole.folder);
        return lock ? run_whole(given, *operation.value(), std::move(whole)) : complain(lock.error());
    }
    if (!given.from.empty() || !given.to.empty() || given.resume) {
        return complain({"--from, --to and --resume are for operations, and " + given.curriculum + " is an exercise",
                         "", "--start STATE"});
    }
    AttemptOptions options = attempt_options(given, set.value(), context);
    const Result<FolderLock> lock = FolderLock::take(options.folder);
    if (!lock) {
        return complain(lock.error());
    }
    Result<SaveOptions> save = save_options_of(given.save_state);
    if (!save) {
        return complain(save.error());
    }
    options.save = std::move(save).value();
    const std::filesystem::path kept_in = std::filesystem::path(options.save.path).parent_path();
    if (!kept_in.empty() && !std::filesystem::is_directory(kept_in)) {
        return complain({"there is no such folder", kept_in.string(), "--save-state FILE in a folder that is there"});
    }
    Result<Start> start =
        find_start({given.curriculum, given.start, set.value(), context.root, given.json, given.opening});
    if (!start) {
        return complain(start.error());
    }
    options.start = std::move(start).value();
    Result<KeptAttempt> kept = begin_kept(given, options);
    if (!kept) {
        return complain(kept.error());
    }
    options.comparison = kept.value().comparison();
    const Result<AttemptResult> result = attempt(options);
    if (!result) {
        kept.value().give_up();
        return complain(result.error());
    }
    const Status stored = kept.value().finish(result.value().report);
    if (!result.value().drawing_note.empty()) {
        std::fprintf(stderr, "rhexis: no pictures: %s\n", result.value().drawing_note.c_str());
    }
    if (given.json) {
        std::cout << result.value().report.dump(2) << '\n';
    } else {
        print_summary(given, options.folder, result.value());
    }
    if (!stored) {
        return complain(stored.error());
    }
    if (!result.value().script_error.empty()) {
        return complain({result.value().script_error, "", "the exercise ended there; its recording is kept"},
                        found_failures);
    }
    if (!options.save.path.empty() && !result.value().saved) {
        return complain({"no state was kept: its moment did not come", given.save_state, ""}, found_failures);
    }
    if (!result.value().html_error.empty()) {
        return complain({"no report.html: " + result.value().html_error, "", ""});
    }
    return done;
}

}  // namespace

void add_run(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("run", "Run an exercise headless, by a virtual surgeon");
    command->footer(run_help);
    auto given = std::make_shared<RunOptions>();
    command->add_option("curriculum", given->curriculum, "Folder, file, or name of one in curricula/")->required();
    command
        ->add_option("--surgeon", given->surgeon, "Who operates: expert, novice, a, b, c, d, none or random [expert]")
        ->capture_default_str();
    command->add_option("--seed", given->seed, "Seed of all chance in the run")->capture_default_str();
    command->add_option("--patient", given->patient, "Patient file (JSON), as in assets/patients/");
    command->add_option("--start", given->start, "Begin in a state: a file, or a name in the exercise's starts.lua");
    command->add_option(
        "--opening", given->opening,
        "Of the bag that an implant is laid into: where it was torn. A state, a recording or the folder "
        "of a run of a capsulorhexis, or EXERCISE:START");
    command->add_option("--save-state", given->save_state,
                        "Keep the state at the end to start from, or FILE@SECONDS, or FILE@CONDITION");
    command->add_option("--out", given->out, "Folder for everything [runs/CURRICULUM-SURGEON-SEED]");
    command->add_flag("--json", given->json, "Print report.json on stdout instead of a summary");
    CLI::Option* video = command->add_flag("--video", given->video, "Make a video, 640x480, 25 pictures a second");
    command->add_flag("--no-pictures", given->no_pictures, "Draw nothing")->excludes(video);
    command->add_option("--set", given->set, "Change a value: patient.*, goal.*, or a setting (repeatable)")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--level", given->level, "Difficulty: one of the exercise's levels");
    command->add_option("--mode", given->mode, "teaching: hints and advice are said; exam: none [as the exercise says]")
        ->check(CLI::IsMember({"teaching", "exam"}));
    command->add_option("--eye", given->eye, "Which eye of the patient [as the exercise says]")
        ->check(CLI::IsMember({"right", "left"}));
    command->add_option("--hand", given->hand, "Of the surgeon, for the main instrument [as the exercise says]")
        ->check(CLI::IsMember({"right", "left"}));
    command->add_option("--language", given->language, language_help);
    command->add_flag("--watch", given->watch, "Read the exercise again between two steps when its files have changed");
    command->add_option("--threads", given->threads, "Threads; the result does not depend on it")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    add_instruction_set(*command, given->instruction_set);
    command->add_option("--from", given->from, "Of an operation: the part to begin with");
    command->add_option("--to", given->to, "Of an operation: the last part to do");
    command->add_flag("--resume", given->resume, "Of an operation: go on after the parts that are whole in --out");
    command->add_option("--trainee", given->keep.trainee, "Store the attempt under this pseudonym [nothing is stored]");
    command->add_option("--cohort", given->keep.cohort, "Of the trainee [as before]");
    command->add_option("--arm", given->keep.arm, "Of the trainee, in a trial [as before]");
    command->add_option("--course", given->keep.course,
                        "Course of the trainee, whose closed lessons are told [RHEXIS_COURSE, or none]");
    command->add_option("--records", given->keep.store,
                        "File to store in [RHEXIS_RECORDS, or rhexis/records.db in the user's data folder]");
    command->add_option("--limit", given->limit_s, "End the run at this simulated time [s]")->capture_default_str();
    command->callback([given, &context] { context.status = run(*given, context); });
}

}  // namespace rhexis::cli
