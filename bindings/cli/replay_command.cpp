// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis replay: a recording described, simulated again and compared, judged again, or filmed.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "base/folder_lock.hpp"
#include "base/hash.hpp"
#include "cli/command.hpp"
#include "cli/language.hpp"
#include "cli/station_library.hpp"
#include "lua/operation_script.hpp"
#include "session/replay.hpp"
#include "station/station.hpp"
#include "trial/film.hpp"
#include "trial/pictures.hpp"
#include "trial/places.hpp"
#include "trial/progress.hpp"
#include "trial/report_json.hpp"
#include "trial/rescore.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* replay_help =
    "Without an option it says what the recording holds.\n"
    "\n"
    "  rhexis replay runs/groove-expert-1 --verify           simulate again, compare every step\n"
    "  rhexis replay runs/groove-expert-1 --score-with my_exercise/\n"
    "  rhexis replay runs/groove-expert-1 --score-with rubrics/ico_oscar.lua      same exercise, another rubric\n"
    "  rhexis replay runs/groove-expert-1 --video --out film/\n"
    "\n"
    "  rhexis replay runs/groove-person-20261128-101500 --window     look at it again, with what happened and why\n"
    "\n"
    "  rhexis replay runs/full_operation-expert-1 --score-with full_operation     all its parts\n"
    "\n"
    "A recording that was cut short (recording.rhx.part) is used up to its last whole step.";

/// Measures may differ this much, relatively, on a machine whose linear algebra rounds otherwise.
constexpr double tolerance_across_machines = 1e-3;

struct ReplayOptions {
    std::string recording;
    std::string score_with;
    std::string out;
    bool verify = false;
    bool video = false;
    bool json = false;
    int threads = 0;
    std::string instruction_set;
    bool window = false;
    station::DebriefingOptions debriefing;
};

nlohmann::json describe(const Recording& recording, const std::string& path) {
    const double end_s = recording.steps.empty() ? 0.0 : recording.steps.back().observation.time_s;
    nlohmann::json identity = nlohmann::json::parse(recording.header.identity, nullptr, false);
    return {{"recording", path},
            {"curriculum", recording.header.curriculum},
            {"identity", identity.is_discarded() ? nlohmann::json(nullptr) : identity},
            {"surgeon", recording.header.surgeon},
            {"seed", recording.header.seed},
            {"steps", recording.steps.size()},
            {"duration_s", end_s},
            {"state_hash", hex(recording.steps.empty() ? recording.start.hash : recording.steps.back().hash)},
            {"checkpoints", recording.checkpoints.size()},
            {"whole", recording.whole},
            {"build", recording.header.build}};
}

void print_description(const nlohmann::json& d) {
    std::printf("%s: %s by %s, seed %llu\n", d["recording"].get<std::string>().c_str(),
                d["curriculum"].get<std::string>().c_str(), d["surgeon"].get<std::string>().c_str(),
                static_cast<unsigned long long>(d["seed"].get<std::uint64_t>()));
    std::printf("  %llu steps, %.1f s simulated, %llu checkpoints, made by %s\n",
                static_cast<unsigned long long>(d["steps"].get<std::uint64_t>()), d["duration_s"].get<double>(),
                static_cast<unsigned long long>(d["checkpoints"].get<std::uint64_t>()),
                d["build"].get<std::string>().c_str());
}

int verified(const Recording& recording, const Verification& result, nlohmann::json& out) {
    out["verified_steps"] = result.steps;
    out["identical"] = !result.divergence.has_value();
    if (!result.divergence) {
        out["verdict"] = "identical: all " + std::to_string(result.steps) + " steps end in the recorded state";
        return done;
    }
    const Divergence& first = *result.divergence;
    out["first_divergence"] = {{"step", first.step}, {"measure", first.measure}, {"relative", first.relative}};
    std::string verdict = "differs first in step " + std::to_string(first.step);
    if (!first.measure.empty()) {
        char text[96];
        std::snprintf(text, sizeof text, " (%s by %.2g, relative)", first.measure.c_str(), first.relative);
        verdict += text;
    }
    const bool other_machine = recording.header.build != build_note();
    if (other_machine) {
        verdict += "; recorded by " + recording.header.build + ", this is " + build_note();
    }
    const bool close = other_machine && result.worst_measure <= tolerance_across_machines;
    if (close) {
        verdict += ": all measures agree to the tolerance across machines";
    }
    out["verdict"] = verdict;
    return close ? done : found_failures;
}

int verify_recording(const Recording& recording, const ReplayOptions& given, nlohmann::json& out) {
    Progress progress("verify", given.json);
    const Result<Verification> result = verify(recording, [&](std::uint64_t step, std::uint64_t of) {
        progress.show(static_cast<double>(step) / static_cast<double>(of), "step " + std::to_string(step));
    });
    return result ? verified(recording, result.value(), out) : complain(result.error());
}

int score(const Recording& recording, const ReplayOptions& given, const Context& context, nlohmann::json& out) {
    const ExerciseOptions options = judge_of(recording, given.score_with, context.root);
    const Result<Rescore> result = rescore(recording, options);
    if (!result) {
        return complain(result.error());
    }
    const Rescore& rescored = result.value();
    out["scored_by"] = rescored.identity;
    out["result"] = rescored.result;
    out["judged_steps"] = rescored.judged;
    out["simulated_from_step"] = rescored.simulated;
    out["score"] = score_line(rescored.result);
    if (rescored.simulated > 0) {
        std::fprintf(stderr, "rhexis: from step %llu on simulated again: %s\n",
                     static_cast<unsigned long long>(rescored.simulated), rescored.difference.c_str());
    }
    return rescored.script_error.empty() ? done : complain({rescored.script_error, "", ""}, found_failures);
}

int film(const Recording& recording, const ReplayOptions& given, nlohmann::json& out) {
    const std::filesystem::path beside = std::filesystem::path(given.recording).parent_path() / "replay";
    const std::string folder = given.out.empty() ? beside.string() : given.out;
    const Result<FolderLock> lock = FolderLock::take(folder);
    const Status prepared = lock ? prepare_folder(folder) : Status(lock.error());
    if (!prepared) {
        return complain(prepared.error());
    }
    Result<PictureBook> book = PictureBook::create(folder, true);
    if (!book) {
        return complain(book.error());
    }
    const Status filmed = film_recording(recording, book.value(), true, given.json);
    if (!filmed) {
        return complain(filmed.error());
    }
    out["video"] = folder + "/video.mp4";
    return done;
}

void print_found(const nlohmann::json& out) {
    print_description(out);
    for (const char* key : {"verdict", "score", "video"}) {
        if (out.contains(key)) {
            std::printf("  %s: %s\n", key, out[key].get<std::string>().c_str());
        }
    }
}

/// The result depends on neither.
void simulate_with(const ReplayOptions& given, SceneDescription& scene) {
    scene.threads = given.threads > 0 ? given.threads : scene.threads;
    scene.instruction_set = given.instruction_set;
}

/// The operation that a run was of, by its name.
Result<std::string> operation_of(const std::string& folder) {
    const Result<nlohmann::json> report = read_json_file(folder + "/report.json");
    if (!report) {
        return report.error();
    }
    const nlohmann::json named = report.value().value("curriculum", nlohmann::json());
    if (!named.is_object() || !named.contains("id") || !named["id"].is_string()) {
        return Error{"it does not say which operation it was", folder + "/report.json", ""};
    }
    return named["id"].get<std::string>();
}

/// What was asked for of one recording, found in `out`.
int look_at(ReplayOptions given, const Context& context, nlohmann::json& out) {
    given.recording = recording_path(given.recording);
    Result<Recording> read = read_recording(given.recording);
    if (!read) {
        return complain(read.error());
    }
    simulate_with(given, read.value().header.scene);
    const Recording& recording = read.value();
    out = describe(recording, given.recording);
    int status = done;
    if (!recording.whole) {
        out["fault"] = recording.fault;
        std::fprintf(stderr, "rhexis: %s: %s; used up to there\n", given.recording.c_str(), recording.fault.c_str());
        status = recording.fault.starts_with("damaged") ? bad_input : done;
    }
    if (given.verify) {
        status = std::max(status, verify_recording(recording, given, out));
    }
    if (!given.score_with.empty()) {
        status = std::max(status, score(recording, given, context, out));
    }
    if (given.video) {
        status = std::max(status, film(recording, given, out));
    }
    return status;
}

/// In a window, to the end.
int debrief(const ReplayOptions& given, const Context& context) {
    const Result<void*> opened = load_station();
    if (!opened) {
        return complain(opened.error());
    }
    station::DebriefingOptions options = given.debriefing;
    options.root = context.root;
    options.recording = recording_path(given.recording);
    options.language = options.language.empty() ? language_of_environment(context.root) : options.language;
    Status status = success();
    entry_of<station::DebriefingEntry>(opened.value(), station::debriefing_entry_name)(options, status);
    return status ? done : complain(status.error());
}

/// The score over all parts, as `out["result"]`.
int score_whole(const ReplayOptions& given, const std::vector<std::string>& parts, const Context& context,
                nlohmann::json& out) {
    const std::string rubric = find_rubric(given.score_with, context.root);
    const Result<std::string> name =
        rubric.empty() ? Result<std::string>(given.score_with) : operation_of(given.recording);
    if (!name) {
        return complain(name.error());
    }
    const Result<std::optional<Operation>> operation = load_operation(name.value(), context.root);
    if (!operation) {
        return complain(operation.error());
    }
    if (!operation.value()) {
        return complain({"these are the parts of an operation, and " + given.score_with + " is an exercise",
                         given.recording, "an operation or a rubric, or one of the folders in parts/"});
    }
    const Result<Rescore> whole = rescore_operation(*operation.value(), rubric, parts, context.root);
    if (!whole) {
        return complain(whole.error(), found_failures);
    }
    const Rescore& judged = whole.value();
    out["result"] = judged.result;
    if (!given.json) {
        std::printf("%s: %zu parts\n  score: %s\n", given.recording.c_str(), parts.size(),
                    score_line(judged.result).c_str());
    }
    return judged.script_error.empty() ? done : complain({judged.script_error, "", ""}, found_failures);
}

/// Every part by itself, and the score over all of them.
int replay_whole(const ReplayOptions& given, const std::vector<std::string>& parts, const Context& context) {
    nlohmann::json out = {{"recording", given.recording}};
    int status = given.score_with.empty() ? done : score_whole(given, parts, context, out);
    const bool each = given.score_with.empty() || given.verify || given.video;
    for (std::size_t i = 0; each && i < parts.size(); ++i) {
        ReplayOptions own = given;
        own.recording = parts[i];
        own.score_with.clear();
        own.out = given.out.empty() ? "" : given.out + "/" + std::filesystem::path(parts[i]).filename().string();
        nlohmann::json found;
        const int looked = look_at(own, context, found);
        status = std::max(status, looked);
        if (!given.json && !found.is_null()) {
            print_found(found);
        }
        out["parts"].push_back(std::move(found));
    }
    if (given.json && out.size() > 1) {
        std::cout << out.dump(2) << '\n';
    }
    return status;
}

int replay(const ReplayOptions& given, const Context& context) {
    const std::vector<std::string> parts = part_folders(given.recording);
    if (given.window) {
        return parts.empty() ? debrief(given, context)
                             : complain({"an operation is looked at part by part", given.recording,
                                         "one of the folders in " + given.recording + "/parts"});
    }
    if (!parts.empty()) {
        return replay_whole(given, parts, context);
    }
    nlohmann::json out;
    const int status = look_at(given, context, out);
    if (out.is_null()) {
        return status;
    }
    if (given.json) {
        std::cout << out.dump(2) << '\n';
    } else {
        print_found(out);
    }
    return status;
}

}  // namespace

void add_replay(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("replay", "Verify, judge again or film a recording");
    command->footer(replay_help);
    auto given = std::make_shared<ReplayOptions>();
    command->add_option("recording", given->recording, "A recording (.rhx), or the folder of a run")->required();
    command->add_flag("--verify", given->verify, "Simulate again and compare the state after every step");
    command
        ->add_option("--score-with", given->score_with,
                     "Judge again, by this exercise (folder, file or name) or rubric")
        ->type_name("EXERCISE|RUBRIC");
    command->add_flag("--video", given->video, "Simulate again and make a video");
    command->add_option("--out", given->out, "Folder for the video [replay/ beside the recording]")->needs("--video");
    command->add_option("--threads", given->threads, "Threads to simulate with [as recorded]")
        ->check(CLI::Range(1, 64));
    add_instruction_set(*command, given->instruction_set);
    command->add_flag("--json", given->json, "Print what was found as JSON");
    CLI::Option* window = command->add_flag("--window", given->window, "Look at it again, in a window");
    station::DebriefingOptions& debriefing = given->debriefing;
    command
        ->add_option("--ghost", debriefing.ghost,
                     "With --window: an expert's run of the same exercise, to compare with")
        ->needs(window);
    command->add_option("--at", debriefing.at_s, "With --window: begin at this time [s]")
        ->check(CLI::Range(0.0, 1e6))
        ->needs(window);
    command->add_option("--right", debriefing.right_deg, "With --window: the camera so many degrees round the eye")
        ->check(CLI::Range(-70.0, 70.0))
        ->needs(window);
    command->add_option("--up", debriefing.up_deg, "Likewise, away from the surgeon")
        ->check(CLI::Range(-70.0, 70.0))
        ->needs(window);
    command->add_option("--language", debriefing.language, "With --window: en, fr, ...")->needs(window);
    command->add_flag("--full-screen", debriefing.full_screen, "With --window")->needs(window);
    add_window_size(*command, debriefing.width, debriefing.height);
    command->add_option("--seconds", debriefing.seconds, "With --window: so long [until it is closed]")->needs(window);
    command->add_option("--screenshot", debriefing.screenshot, "PNG file for what the window shows in the end")
        ->needs(window);
    command->callback([given, &context] { context.status = replay(*given, context); });
}

}  // namespace rhexis::cli
