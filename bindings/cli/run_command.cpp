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
#include "cli/attempt_arguments.hpp"
#include "cli/command.hpp"
#include "cli/input_option.hpp"
#include "cli/kept_attempt.hpp"
#include "cli/language.hpp"
#include "cli/run_folder.hpp"
#include "cli/station_library.hpp"
#include "eye/patient.hpp"
#include "track/track_options.hpp"
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
    "  rhexis run groove --input vrpn://192.168.1.7    by whom a tracking system sees, as fast as the clock goes\n"
    "  rhexis run phaco_sculpt --through my_rig/track.json    hands as cameras see them; see rhexis track --help\n"
    "  rhexis run full_operation                  all its parts, one after the other\n"
    "  rhexis run full_operation --from capsulorhexis --to capsulorhexis\n"
    "  rhexis run full_operation --resume         without the parts that are there already\n"
    "  rhexis run groove --accuracy measure --limit 20    how far off: again at twice the resolution, by the same "
    "hand\n"
    "  rhexis run groove --trainee P07 --cohort 2026    the attempt is stored; see rhexis records --help\n"
    "\n"
    "Without a device to draw with the run goes on without pictures and says so; with --video it does not start.\n"
    "Without --trainee nothing is stored but the run's own folder.";

constexpr double longest_moment = 7200.0;  // [s] simulated

struct RunOptions : AttemptArguments {
    std::string save_state;
    bool json = false;
    bool video = false;
    bool no_pictures = false;
    std::string from;
    std::string to;
    bool resume = false;
    bool watch = false;
    std::string accuracy;
    TrackedArguments tracked;
    std::string through;
    std::string level;
    double moved_um = 0.0;
};

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
    const Status range = check_range("--save-state: time", seconds, 0.0, longest_moment);
    return range ? Result<SaveOptions>(save) : range.error();
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
    for (const auto& [option, value] :
         {std::pair("--start", given.start), std::pair("--opening", given.opening),
          std::pair("--save-state", given.save_state), std::pair("--accuracy", given.accuracy),
          std::pair("--through", given.through)}) {
        if (!value.empty()) {
            return Error{std::string(option) + " is for exercises, and " + given.curriculum + " is an operation", "",
                         "--from PART and --to PART"};
        }
    }
    if (!given.through.empty() || given.moved_um > 0.0) {
        return Error{std::string(given.through.empty() ? "--moved" : "--through") + " is for exercises, and " +
                         given.curriculum + " is an operation",
                     "", "its parts, one by one"};
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

AttemptOptions run_options(const RunOptions& given, std::map<std::string, std::string> set, const std::string& root) {
    AttemptOptions options = attempt_options(given, std::move(set), root);
    options.watch = given.watch;
    options.measure_accuracy = given.accuracy == "measure";
    options.drawing = given.video ? Drawing::video : given.no_pictures ? Drawing::none : Drawing::if_possible;
    return options;
}

/// By a person, whom nobody can be beside.
void begin_as_person(RunOptions& given) {
    given.surgeon = "none";
    given.set.emplace_back(std::string("input=") + station::tracked_device);
    given.keep.input = station::tracked_device;
    if (given.out.empty()) {
        const std::string who = given.keep.trainee.empty() ? "person" : given.keep.trainee;
        given.out = "runs/" + folder_name_of(exercise_name(given.curriculum), who);
    }
}

/// What hands go through; null: nothing.
Result<std::unique_ptr<SampleLink>> open_link(const RunOptions& given) {
    if (given.moved_um > 0.0) {
        return std::unique_ptr<SampleLink>(std::make_unique<MovedSamples>(1e-3 * given.moved_um, given.seed));
    }
    if (given.through.empty()) {
        return std::unique_ptr<SampleLink>();
    }
    const Result<void*> opened = load_tracking();
    if (!opened) {
        return opened.error();
    }
    Result<std::unique_ptr<SampleLink>> link = Error{"nothing was opened", "", ""};
    entry_of<tracking::ChainEntry>(opened.value(), tracking::chain_entry_name)({given.through, given.level, given.seed},
                                                                               link);
    return link;
}

/// After an attempt that was ended because its clock stood.
void tell_gave_up(const HeadlessPerson* person, double give_up_s) {
    if (person != nullptr && person->gave_up()) {
        std::fprintf(stderr,
                     "rhexis: the clock stood for %g s: the attempt was ended there, and its recording is kept\n",
                     give_up_s);
    }
}

int run(RunOptions given, const Context& context) {
    given.keep.root = context.root;
    const bool by_person = !given.tracked.input.empty();
    if (by_person) {
        begin_as_person(given);
    }
    Status status = check_attempt_arguments(given);
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
    if (operation.value() && by_person) {
        return complain(
            {"--input is for exercises, and " + given.curriculum + " is an operation", "", "its parts, one by one"});
    }
    if (operation.value()) {
        AttemptOptions whole = run_options(given, std::move(set).value(), context.root);
        const Result<FolderLock> lock = FolderLock::take(whole.folder);
        return lock ? run_whole(given, *operation.value(), std::move(whole)) : complain(lock.error());
    }
    if (!given.from.empty() || !given.to.empty() || given.resume) {
        return complain({"--from, --to and --resume are for operations, and " + given.curriculum + " is an exercise",
                         "", "--start STATE"});
    }
    AttemptOptions options = run_options(given, set.value(), context.root);
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
    std::unique_ptr<HeadlessPerson> person;
    if (by_person) {
        Result<std::unique_ptr<HeadlessPerson>> connected = HeadlessPerson::connect(given.tracked, options.exercise);
        if (!connected) {
            return complain(connected.error());
        }
        person = std::move(connected).value();
        options.guest = &person->guest();
    }
    const Result<std::unique_ptr<SampleLink>> link = open_link(given);
    if (!link) {
        return complain(link.error());
    }
    options.link = link.value().get();
    Result<KeptAttempt> kept = begin_kept(given, options);
    if (!kept) {
        return complain(kept.error());
    }
    options.comparison = kept.value().comparison();
    const Result<AttemptResult> result = attempt(options);
    tell_gave_up(person.get(), given.tracked.give_up_s);
    if (!result) {
        kept.value().give_up();
        return complain(result.error());
    }
    const nlohmann::json report = report_of(result.value());
    const Status stored = kept.value().finish(report);
    if (!result.value().drawing_note.empty()) {
        std::fprintf(stderr, "rhexis: no pictures: %s\n", result.value().drawing_note.c_str());
    }
    if (given.json) {
        std::cout << report.dump(2) << '\n';
    } else {
        print_summary(given, by_person ? "person" : given.surgeon, options.folder, result.value());
        if (result.value().saved) {
            std::printf("  state      %s\n", options.save.path.c_str());
        }
    }
    if (!stored) {
        return complain(stored.error());
    }
    if (!result.value().facts.script_error.empty()) {
        return complain({result.value().facts.script_error, "", "the exercise ended there; its recording is kept"},
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
    CLI::Option* surgeon = command
                               ->add_option("--surgeon", given->surgeon,
                                            "Who operates: expert, novice, a, b, c, d, none or random [expert]")
                               ->capture_default_str();
    CLI::Option* input = command
                             ->add_option("--input", given->tracked.input,
                                          "Operated by whom a tracking system sees, at vrpn://ADDRESS[:PORT] or "
                                          "vrpn+tcp://ADDRESS[:PORT], in place of a virtual surgeon")
                             ->check(is_tracked_input)
                             ->excludes(surgeon);
    CLI::Option* through = command->add_option("--through", given->through,
                                               "The surgeon's hands as this synthetic rig sees them (rhexis track)");
    through->excludes(input);
    command->add_option("--cameras", given->level, "With --through: images, or markers alone, faster [as the rig says]")
        ->check(CLI::IsMember({"images", "markers"}))
        ->needs(through);
    command
        ->add_option("--moved", given->moved_um,
                     "Each instrument lies so far beside where the surgeon has it [um]: what is chance in a score")
        ->check(CLI::Range(0.001, 1000.0))
        ->excludes(through)
        ->excludes(input);
    command->add_option("--registration", given->tracked.registration, registration_help)->needs(input);
    command->add_option("--wait", given->tracked.wait_s, "With --input: for a server [s]")
        ->check(CLI::Range(0.1, 3600.0))
        ->needs(input)
        ->capture_default_str();
    command
        ->add_option("--give-up", given->tracked.give_up_s, "With --input: end where the clock has stood so long [s]")
        ->check(CLI::Range(0.1, 86400.0))
        ->needs(input)
        ->capture_default_str();
    command->add_option("--save-state", given->save_state,
                        "Keep the state at the end to start from, or FILE@SECONDS, or FILE@CONDITION");
    command->add_flag("--json", given->json, "Print report.json on stdout instead of a summary");
    CLI::Option* video = command->add_flag("--video", given->video, "Make a video, 640x480, 25 pictures a second");
    command->add_flag("--no-pictures", given->no_pictures, "Draw nothing")->excludes(video);
    command->add_flag("--watch", given->watch, "Read the exercise again between two steps when its files have changed");
    command
        ->add_option("--accuracy", given->accuracy,
                     "measure: simulate the attempt again at twice the resolution, and tell how far off it was")
        ->check(CLI::IsMember({"measure"}));
    command->add_option("--from", given->from, "Of an operation: the part to begin with");
    command->add_option("--to", given->to, "Of an operation: the last part to do");
    command->add_flag("--resume", given->resume, "Of an operation: go on after the parts that are whole in --out");
    add_attempt_arguments(*command, *given);
    command->callback([given, &context] { context.status = run(*given, context); });
}

}  // namespace rhexis::cli
