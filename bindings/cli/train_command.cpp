// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis train: a person operates, in a window.
#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "base/folder_lock.hpp"
#include "cli/attempt_arguments.hpp"
#include "cli/command.hpp"
#include "cli/course_file.hpp"
#include "cli/input_option.hpp"
#include "cli/language.hpp"
#include "cli/station_library.hpp"
#include "station/event_source.hpp"
#include "station/menu.hpp"
#include "station/station.hpp"
#include "station/theatre.hpp"
#include "trial/places.hpp"
#include "trial/starts.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* train_help =
    "Opens the microscope's view: you operate. Report, pictures and recording come as of any run.\n"
    "\n"
    "  rhexis train                                       choose from a menu\n"
    "  rhexis train capsulorhexis\n"
    "  rhexis train groove --full-screen --trainee P07\n"
    "  rhexis train groove --events mine.jsonl            what you do is kept too, event by event\n"
    "  rhexis train --events mine.jsonl --again           the same done again, step by step\n"
    "  rhexis train --resume runs/groove-person-20261128-101500    on with an attempt that was cut short\n"
    "  rhexis train groove --input gamepad                with two sticks and triggers\n"
    "  rhexis train groove --input vrpn://192.168.1.7     with instruments that a tracking system sees\n"
    "  rhexis train surge --monitor                       with the theatre's monitor, at which an instructor sits\n"
    "\n"
    "F1 shows what each key and button does; E takes an instrument, the cursor moves its tip, the wheel lifts it,\n"
    "1, 2 and 3 press the pedal, P stops the clock, Escape ends. docs/station.md has the rest.";

const std::map<std::string, Stereo> stereo_names = {
    {"off", Stereo::off}, {"side-by-side", Stereo::side_by_side}, {"anaglyph", Stereo::anaglyph}};

struct TrainOptions : AttemptArguments {
    std::string resume;
    std::string mapping;
    std::string events;
    bool again = false;
    std::string by;
    std::string input = "mouse";
    std::string registration;
    bool live = false;
    bool typed = false;
    int width = 1280;
    int height = 960;
    bool full_screen = false;
    std::string stereo = "off";
    std::string ghost;
    std::string screenshot;
    bool no_open = false;
    int picture_every = 4;
    bool warns = false;
    bool silent = false;
    bool monitor = false;
    std::string theatre;
};

/// What of a recording says how its attempt was begun.
void begin_as(const RecordingHeader& header, AttemptArguments& given) {
    given.curriculum = header.curriculum;
    given.seed = header.seed;
    for (const auto& [key, value] : header.set) {
        given.set.push_back(key + "=" + value);
    }
}

/// What the file of events says of the attempt that it is of; what is given besides must agree.
Status begin_as_events(TrainOptions& given) {
    const Result<station::EventFile> file = station::read_events(given.events);
    if (!file) {
        return file.error();
    }
    const nlohmann::json& header = file.value().header;
    const auto text = [&header](const char* name, const std::string& otherwise) {
        return header.contains(name) && header[name].is_string() ? header[name].get<std::string>() : otherwise;
    };
    const std::string curriculum = text("curriculum", "");
    if (curriculum.empty() || (!given.curriculum.empty() && given.curriculum != curriculum)) {
        return Error{"these are events of " + (curriculum.empty() ? "no exercise" : curriculum) + ", not of " +
                         (given.curriculum.empty() ? "one" : given.curriculum),
                     given.events, ""};
    }
    given.curriculum = curriculum;
    given.start = text("start", "");
    given.opening = text("opening", "");
    given.input = text("input", given.input);
    if (header.contains("seed") && header["seed"].is_number_unsigned()) {
        given.seed = header["seed"].get<std::uint64_t>();
    }
    if (header.contains("limit_s") && header["limit_s"].is_number()) {
        given.limit_s = header["limit_s"].get<double>();
    }
    const nlohmann::json set = header.contains("set") ? header["set"] : nlohmann::json::object();
    for (const auto& [key, value] : set.items()) {
        given.set.push_back(key + "=" + (value.is_string() ? value.get<std::string>() : value.dump()));
    }
    return success();
}

/// An attempt that was cut short, as far as its recording goes; it stays in its folder under another name.
Result<GoingOn> cut_short(const std::string& folder, const TrainOptions& given) {
    const std::string path = recording_path(folder);
    if (!path.ends_with(".part")) {
        return Error{"no attempt was cut short in this folder", folder, "one with recording.rhx.part"};
    }
    Result<Recording> recording = read_recording(path);
    if (!recording) {
        return recording.error();
    }
    recording.value().header.scene.threads = given.threads;
    recording.value().header.scene.instruction_set = given.instruction_set;
    const std::uint64_t last = recording.value().steps.size();
    return going_on_from(std::move(recording).value(), last);
}

/// Where rhexis run leaves one, if it did.
std::string expert_run(const std::string& curriculum) {
    for (const char* who : {"-expert-1", "-d-101"}) {
        std::string folder = "runs/" + exercise_name(curriculum) + who;
        std::error_code ignored;
        if (std::filesystem::exists(folder + "/recording.rhx", ignored)) {
            return folder;
        }
    }
    return "";
}

/// The theatre's monitor, as a process of its own that stays when this one ends.
void open_monitor(const std::string& address, const std::string& language) {
    std::string program = program_path();
    std::string command = "monitor";
    std::string at = address;
    std::string option = "--language";
    std::string spoken = language;
    char* const words[] = {program.data(), command.data(), at.data(), option.data(), spoken.data(), nullptr};
    pid_t child = 0;
    if (::posix_spawn(&child, program.c_str(), nullptr, nullptr, words, environ) != 0) {
        complain({"the theatre's monitor cannot be started", program, "rhexis monitor, in another terminal"});
    }
}

/// With what the desktop opens pages with; where there is none, its path has been told.
void open_report(const std::string& folder) {
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
        return;
    }
    const std::string page = folder + "/report.html";
    std::string program = "xdg-open";
    std::string argument = page;
    char* const words[] = {program.data(), argument.data(), nullptr};
    pid_t child = 0;
    posix_spawn_file_actions_t quiet;  // what a browser says is not for this terminal
    ::posix_spawn_file_actions_init(&quiet);
    ::posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&quiet, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    static_cast<void>(::posix_spawnp(&child, program.c_str(), &quiet, nullptr, words, environ));
    ::posix_spawn_file_actions_destroy(&quiet);
}

/// A program that was just killed holds its folder until the system has cleared it away.
Result<FolderLock> lock_when_free(const std::string& folder) {
    constexpr int tries = 20;
    for (int i = 0; i < tries; ++i) {
        if (Result<FolderLock> lock = FolderLock::take(folder)) {
            return lock;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return FolderLock::take(folder);
}

/// A person's attempt is not begun where its recording could not be kept.
Status check_room(const std::string& folder, double limit_s) {
    constexpr double bytes_per_s = 0.3e6;  // of the largest exercises, measured: 0.23e6
    std::error_code unknown;
    const std::filesystem::space_info space = std::filesystem::space(folder, unknown);
    const double needed = bytes_per_s * limit_s;
    if (unknown || static_cast<double>(space.available) >= needed) {
        return success();
    }
    const auto megabytes = [](double bytes) { return std::to_string(static_cast<long>(bytes / 1e6)) + " MB"; };
    return Error{"no room for a recording: " + megabytes(static_cast<double>(space.available)) + " are free", folder,
                 megabytes(needed) + " for " + std::to_string(static_cast<int>(limit_s)) +
                     " s, another --out, or a shorter --limit"};
}

/// One attempt, from what was given to its summary.
int train_once(TrainOptions given, void* opened, const Context& context) {
    given.keep.root = context.root;
    given.surgeon = "none";
    std::optional<GoingOn> before;
    if (!given.resume.empty()) {
        Result<GoingOn> found = cut_short(given.resume, given);
        if (!found) {
            return complain(found.error());
        }
        before.emplace(std::move(found).value());
        begin_as(before->recording.header, given);
        given.out = given.resume;
    } else if (given.again) {
        if (const Status begun = begin_as_events(given); !begun) {
            return complain(begun.error());
        }
    }
    const Status status = check_attempt_arguments(given);
    if (!status) {
        return complain(status.error());
    }
    if (!given.by.empty() && station::is_tracked(given.input)) {
        return complain({"--by works a mouse or a gamepad, and not " + given.input, "",
                         "rhexis vrpn serve RUN, which tells a recording as a tracking system would"});
    }
    Result<std::map<std::string, std::string>> set = given_settings(given, context.root);
    if (!set) {
        return complain(set.error());
    }
    const std::string device = station::is_tracked(given.input) ? station::tracked_device : given.input;
    set.value().insert_or_assign("input", device);
    given.keep.input = device;
    station::StationOptions options;
    options.attempt = attempt_options(given, set.value(), context.root);
    if (given.out.empty()) {
        const std::string who = given.keep.trainee.empty() ? "person" : given.keep.trainee;
        options.attempt.folder = "runs/" + folder_name_of(exercise_name(given.curriculum), who);
    } else if (const Status free = check_folder(given.out, before.has_value()); !free) {
        return complain(free.error());
    }
    options.mapping = given.mapping;
    options.events = given.events;
    options.again = given.again;
    options.by = given.by;
    options.pad = device == "gamepad";
    options.tracked = device == station::tracked_device;
    options.tracked_at = given.input;
    options.registration = given.registration;
    options.live = given.live;
    options.typed = given.typed;
    options.screenshot = given.screenshot;
    options.width = given.width;
    options.height = given.height;
    options.full_screen = given.full_screen;
    options.ghost = given.ghost.empty() ? expert_run(given.curriculum) : given.ghost;
    options.attempt.watch = given.by.empty() && !given.again;
    options.stereo = stereo_names.at(given.stereo);
    options.picture_every = given.picture_every;
    options.warns = given.warns;
    options.silent = given.silent;
    options.theatre = given.theatre;
    options.begun_with = {{"start", given.start}, {"opening", given.opening}, {"limit_s", given.limit_s}};
    const Result<FolderLock> lock =
        before ? lock_when_free(options.attempt.folder) : FolderLock::take(options.attempt.folder);
    if (!lock) {
        return complain(lock.error());
    }
    if (const Status room = check_room(options.attempt.folder, given.limit_s); !room) {
        return complain(room.error());
    }
    if (before) {
        options.attempt.going_on = &*before;
        if (const Result<std::string> aside = put_aside(recording_path(given.resume)); !aside) {
            return complain(aside.error());
        }
    } else {
        Result<Start> start =
            find_start({given.curriculum, given.start, set.value(), context.root, false, given.opening});
        if (!start) {
            return complain(start.error());
        }
        options.attempt.start = std::move(start).value();
    }
    Result<KeptAttempt> kept = begin_kept(given, options.attempt, before.has_value());
    if (!kept) {
        return complain(kept.error());
    }
    options.attempt.comparison = kept.value().comparison();
    Result<AttemptResult> result = Error{"nothing was done", "", ""};
    entry_of<station::Entry>(opened, station::entry_name)(options, result);
    if (!result) {
        kept.value().give_up();
        return complain(result.error());
    }
    const AttemptResult& attempt = result.value();
    const Status stored = kept.value().finish(report_of(attempt));
    print_summary(given, "person", options.attempt.folder, attempt);
    if (!given.no_open && given.by.empty() && !given.again && attempt.html_error.empty()) {
        open_report(options.attempt.folder);
    }
    if (!stored) {
        return complain(stored.error());
    }
    if (!attempt.facts.script_error.empty()) {
        return complain({attempt.facts.script_error, "", "the exercise ended there; its recording is kept"},
                        found_failures);
    }
    return attempt.html_error.empty() ? done : complain({"no report.html: " + attempt.html_error, "", ""});
}

/// Exercises in the order in which they are taught.
Result<std::vector<std::string>> lessons_of(const TrainOptions& given, const Context& context) {
    const Result<records::LessonPlan> plan = read_course_or_usual(given.keep.course, context.root);
    if (!plan) {
        return plan.error();
    }
    std::vector<std::string> names;
    for (const records::Lesson& lesson : plan.value().lessons) {
        names.push_back(lesson.exercise);
    }
    return names;
}

/// Without an exercise the menu comes, and comes again after each.
int train(TrainOptions given, const Context& context) {
    const Result<void*> opened = load_station();
    if (!opened) {
        return complain(opened.error());
    }
    if (given.monitor) {
        given.theatre = given.theatre.empty() ? station::usual_theatre() : given.theatre;
        open_monitor(given.theatre, given.language.empty() ? language_of_environment(context.root) : given.language);
    }
    if (!given.curriculum.empty() || given.again || !given.resume.empty()) {
        return train_once(given, opened.value(), context);
    }
    const Result<std::vector<std::string>> lessons = lessons_of(given, context);
    if (!lessons) {
        return complain(lessons.error());
    }
    const std::string language = given.language.empty() ? language_of_environment(context.root) : given.language;
    for (;;) {
        const station::Menu menu = station::collect_menu(context.root, "runs", language, lessons.value());
        if (menu.exercises.empty()) {
            return complain({"there is no exercise to choose", context.root + "/curricula",
                             "RHEXIS_HOME names the folder that has them"});
        }
        Result<station::MenuChoice> choice = Error{"nothing was chosen", "", ""};
        entry_of<station::MenuEntry>(opened.value(), station::menu_entry_name)(menu, choice);
        if (!choice) {
            return complain(choice.error());
        }
        if (choice.value().exercise.empty()) {
            return done;
        }
        TrainOptions chosen = given;
        chosen.curriculum = choice.value().exercise;
        chosen.patient = choice.value().patient.empty() ? given.patient : choice.value().patient;
        chosen.level = choice.value().level.empty() ? given.level : choice.value().level;
        chosen.input = choice.value().pad ? "gamepad" : given.input;
        train_once(chosen, opened.value(), context);  // what goes wrong is told, and the menu comes again
    }
}

}  // namespace

void add_train(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("train", "Operate yourself, in a window");
    command->footer(train_help);
    auto given = std::make_shared<TrainOptions>();
    command->add_option("curriculum", given->curriculum, "Folder, file, or name of one in curricula/ [a menu]");
    add_attempt_arguments(*command, *given);
    command->add_option("--resume", given->resume, "Go on with an attempt that was cut short: its folder");
    command->add_option("--mapping", given->mapping,
                        "What each key and button does [assets/station/mouse.json, or gamepad.json]");
    CLI::Option* events = command->add_option("--events", given->events, "File to keep what you do in, event by event");
    command->add_flag("--again", given->again, "Do what that file holds again, step by step")->needs(events);
    command
        ->add_option("--input", given->input,
                     "What you operate with: mouse, gamepad, or a tracking system, vrpn://ADDRESS[:PORT] or "
                     "vrpn+tcp://ADDRESS[:PORT]")
        ->check(is_input)
        ->capture_default_str();
    command->add_option("--registration", given->registration, registration_help);
    CLI::Option* by =
        command->add_option("--by", given->by, "A virtual surgeon works the devices in your place: a, b, c or d");
    CLI::Option* live = command->add_flag("--live", given->live, "With --by: by the wall clock")->needs(by);
    command->add_flag("--typed", given->typed, "With --live: through the X server, by xdotool")->needs(live);
    add_window_size(*command, given->width, given->height);
    command->add_flag("--full-screen", given->full_screen, "Without borders, on the whole screen");
    command->add_option("--ghost", given->ghost,
                        "Run whose way H shows [runs/EXERCISE-expert-1, or EXERCISE-d-101, where it is]");
    command->add_option("--screenshot", given->screenshot, "PNG file for what the window shows in the end");
    command->add_flag("--no-open", given->no_open, "Do not open the report at the end");
    command->add_option("--stereo", given->stereo, "off, side-by-side, or anaglyph for red and cyan glasses")
        ->check(CLI::IsMember(stereo_names))
        ->capture_default_str();
    command->add_option("--picture-every", given->picture_every, "With --again: steps from picture to picture")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    command->add_flag("--warnings", given->warns, "Warn of what is about to go wrong (F6); such attempts have aids");
    command->add_flag("--silent", given->silent, "No sound");
    command->add_flag("--monitor", given->monitor, "Open the theatre's monitor beside the window");
    command->add_option("--theatre", given->theatre,
                        "Address that rhexis monitor looks at, as ipc:///tmp/name or tcp://127.0.0.1:5555 [with "
                        "--monitor: of this user on this computer]");
    command->callback([given, &context] { context.status = train(*given, context); });
}

}  // namespace rhexis::cli
