// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis track: the tracking computer.
#include <memory>

#include "cli/command.hpp"
#include "cli/station_library.hpp"
#include "track/track_options.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* track_help =
    "Finds instruments with reflecting spheres in the images of several infra-red cameras, and tells where they are\n"
    "over VRPN and OpenIGTLink. rhexis train --input vrpn://ADDRESS operates with them, on this computer or another.\n"
    "\n"
    "  rhexis track begin my_rig                  a rig without cameras to try it with\n"
    "  rhexis track lenses my_rig/track.json --board dots:13x9x14    what the lenses do, by a board shown to each\n"
    "  rhexis track calibrate my_rig/track.json   where the cameras stand, by a wand that is waved; with a page\n"
    "  rhexis track my_rig/track.json             until it is ended; each body on a line\n"
    "  rhexis track my_rig/track.json --window    with what each camera sees, in a window\n"
    "  rhexis track my_rig/track.json --seconds 2 --picture seen.png    what the cameras saw, with what was made of "
    "it\n"
    "  rhexis track pivot my_rig/track.json phaco    where the tip is, by turning it about its tip\n"
    "  rhexis track measure --seeds 2             how accurate and how fast it is, beside what was aimed at\n"
    "  rhexis track begin my_rig --exercise groove    with what another exercise is done with\n"
    "  rhexis track print my_rig/phaco.json phaco.stl    a replica with struts for the spheres, to print\n"
    "  rhexis track design hook my_rig/hook.json --unlike my_rig/phaco.json    where the spheres of another stand\n"
    "\n"
    "The file says which cameras there are and what is tracked; docs/tracking.md has all its fields.";

template <typename Entry, typename... Arguments>
int call(const char* name, const Arguments&... arguments) {
    const Result<void*> opened = load_tracking();
    if (!opened) {
        return complain(opened.error());
    }
    Status status = success();
    entry_of<Entry>(opened.value(), name)(arguments..., status);
    return status ? done : complain(status.error());
}

/// Options of a command that shows what cameras see where a window is asked for.
std::shared_ptr<bool> add_window(CLI::App& command, ScreenOptions& screen) {
    auto window = std::make_shared<bool>(false);
    command.add_flag("--window", *window, "Show what the cameras see, in a window");
    command.add_option("--screenshot", screen.screenshot, "With --window: PNG file for what it shows in the end");
    add_window_size(command, screen.width, screen.height);
    return window;
}

/// The shared object with windows is loaded where one is asked for.
template <typename Entry, typename Options>
int call_with_window(const char* name, Options given, bool window) {
    if (!window && !given.screen.screenshot.empty()) {
        return complain({"--screenshot is of a window, and there is none", "track", "--window"});
    }
    if (window) {
        const Result<void*> opened = load_station();
        if (!opened) {
            return complain(opened.error());
        }
        given.open_screen = entry_of<OpenScreen>(opened.value(), open_screen_name);
        given.screen.title = "rhexis: " + given.setup;
    }
    return call<Entry>(name, given);
}

void add_calibrate(CLI::App& track, Context& context) {
    CLI::App* command = track.add_subcommand("calibrate", "Where the cameras stand, by a wand that is waved");
    auto given = std::make_shared<tracking::CalibrateOptions>();
    command->add_option("config", given->setup, "The rig's file, as of rhexis track")->required();
    command->add_option("--seconds", given->seconds, "Of the wand")
        ->check(CLI::Range(1.0, 600.0))
        ->capture_default_str();
    command->add_flag("--refine-lenses", given->refine_lenses, "Lenses as well, but for k3");
    command->add_option("--out", given->rig, "File for the rig [the one that it has]");
    command->add_option("--page", given->page, "HTML page with how good it is [calibration.html beside the rig]");
    const std::shared_ptr<bool> window = add_window(*command, given->screen);
    command->callback([given, window, &context] {
        context.status = call_with_window<tracking::CalibrateEntry>(tracking::calibrate_entry_name, *given, *window);
    });
}

void add_lenses(CLI::App& track, Context& context) {
    CLI::App* command = track.add_subcommand("lenses", "The lens of each camera, by a board that is shown to it");
    auto given = std::make_shared<tracking::LensesOptions>();
    command->add_option("config", given->setup, "The rig's file, as of rhexis track")->required();
    command
        ->add_option("--board", given->board,
                     "dots:COLUMNSxROWSxMM or chess:COLUMNSxROWSxMM: how many dots or inner corners, how far apart")
        ->required();
    command->add_option("--views", given->views, "Of the board for each camera, at most")
        ->check(CLI::Range(8, 400))
        ->capture_default_str();
    command->add_option("--seconds", given->seconds, "For which images are looked at, at most")
        ->check(CLI::Range(1.0, 3600.0))
        ->capture_default_str();
    command->add_option("--images", given->images, "Folder with a folder of images for each camera [the rig's source]");
    command->add_option("--keep", given->keep, "Folder for all images, to look at them again with --images");
    command->add_option("--out", given->rig, "File for the rig [the one that it has]");
    command->add_option("--page", given->page, "HTML page with how good it is [calibration.html beside the rig]");
    command->callback(
        [given, &context] { context.status = call<tracking::LensesEntry>(tracking::lenses_entry_name, *given); });
}

void add_pivot(CLI::App& track, Context& context) {
    CLI::App* command = track.add_subcommand("pivot", "Where an instrument's tip is, by turning it about its tip");
    auto given = std::make_shared<tracking::PivotOptions>();
    command->add_option("config", given->setup, "The rig's file")->required();
    command->add_option("body", given->body, "Name of the instrument")->required();
    command->add_option("--seconds", given->seconds, "So long")->check(CLI::Range(1.0, 600.0))->capture_default_str();
    command->callback(
        [given, &context] { context.status = call<tracking::PivotEntry>(tracking::pivot_entry_name, *given); });
}

void add_begin(CLI::App& track, Context& context) {
    CLI::App* command = track.add_subcommand("begin", "A folder with a rig that needs no cameras, to begin with");
    auto given = std::make_shared<tracking::BeginOptions>();
    command->add_option("folder", given->folder, "Empty, or not there yet")->required();
    command->add_option("--exercise", given->exercise, "Whose instruments are tracked; of an operation all its parts'")
        ->capture_default_str();
    command->callback([given, &context] {
        given->root = context.root;
        context.status = call<tracking::BeginEntry>(tracking::begin_entry_name, *given);
    });
}

void add_design(CLI::App& track, Context& context) {
    CLI::App* command =
        track.add_subcommand("design", "Where an instrument's spheres stand, so that it is known by them");
    auto given = std::make_shared<tracking::DesignOptions>();
    command->add_option("instrument", given->instrument, "Its name")->required();
    command->add_option("body", given->body, "File to write")->required();
    command->add_option("--unlike", given->unlike, "Files of bodies that it is not to be taken for");
    command->add_option("--beside", given->beside,
                        "Files of bodies used at the same time: no distance is theirs either");
    command->add_option("--reach", given->reach_mm, "Of a sphere from the handle's axis [mm]")
        ->check(CLI::Range(18.0, 60.0))
        ->capture_default_str();
    command->add_option("--seed", given->seed, "Of chance")->capture_default_str();
    command->callback(
        [given, &context] { context.status = call<tracking::DesignEntry>(tracking::design_entry_name, *given); });
}

void add_measure(CLI::App& track, Context& context) {
    CLI::App* command = track.add_subcommand("measure", "What tracking reaches, on rigs without cameras drawn by seed");
    auto given = std::make_shared<tracking::MeasureOptions>();
    command->add_option("--first-seed", given->first_seed, "Of rig, calibration, clips and noise")
        ->capture_default_str();
    command->add_option("--seeds", given->seeds, "So many")->check(CLI::Range(1, 100))->capture_default_str();
    command->add_option("--marker-seeds", given->marker_seeds, "Of what needs no images [as many]")
        ->check(CLI::Range(1, 1000));
    command->add_option("--image-seconds", given->image_s, "Of each clip that is rendered")
        ->check(CLI::Range(0.2, 10.0))
        ->capture_default_str();
    command->add_option("--marker-seconds", given->marker_s, "Of hands that go fast, without images")
        ->check(CLI::Range(0.2, 20.0))
        ->capture_default_str();
    command->add_option("--identities", given->identity_frames, "Exposures in which a wrong body is looked for")
        ->check(CLI::Range(100, 10000000))
        ->capture_default_str();
    command->add_flag("!--no-chart", given->chart, "Without the chart of detectors");
    command->add_option("--poses", given->poses, "Told over the network of this computer, by TCP and by datagram")
        ->check(CLI::Range(10, 1000000))
        ->capture_default_str();
    command->add_flag("--network", given->network_only, "Only those");
    command->add_flag("--chart", given->chart_only, "Only the chart of detectors")->excludes("--network");
    command->add_flag("--json", given->json, "As JSON");
    command->add_option("--keep", given->keep,
                        "Folder for each part of each seed: what is there is not measured again");
    command->callback(
        [given, &context] { context.status = call<tracking::MeasureEntry>(tracking::measure_entry_name, *given); });
}

void add_print(CLI::App& track, Context& context) {
    CLI::App* command = track.add_subcommand("print", "A replica with struts for a body's spheres, as an STL file");
    auto given = std::make_shared<tracking::PrintOptions>();
    command->add_option("body", given->body, "The body's file")->required();
    command->add_option("stl", given->stl, "File to write")->required();
    command->add_flag("!--without-shape", given->with_shape,
                      "A sleeve with struts alone, to be put on a real instrument");
    command->callback(
        [given, &context] { context.status = call<tracking::PrintEntry>(tracking::print_entry_name, *given); });
}

}  // namespace

void add_track(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("track", "Track instruments by infra-red cameras, and tell where they are");
    command->footer(track_help);
    command->require_subcommand(0, 1);
    auto given = std::make_shared<tracking::TrackOptions>();
    command->add_option("config", given->setup, "JSON file with cameras, bodies and where images come from");
    command->add_option("--seconds", given->seconds, "So long [until it is ended]")->check(CLI::Range(0.0, 1e6));
    command->add_flag("--json", given->json, "Poses as lines of JSON");
    command->add_flag("--silent", given->silent, "Tell nobody over the network");
    command->add_flag("--fast", given->as_fast_as_can_be, "Images that are there already, as fast as can be");
    command->add_option("--keep", given->keep, "Folder for all images, to track them again");
    command->add_option("--picture", given->picture, "PNG file for what the cameras saw in the end");
    add_lenses(*command, context);
    add_calibrate(*command, context);
    add_pivot(*command, context);
    add_begin(*command, context);
    add_design(*command, context);
    add_print(*command, context);
    add_measure(*command, context);
    const std::shared_ptr<bool> window = add_window(*command, given->screen);
    command->callback([given, window, command, &context] {
        if (!command->get_subcommands().empty()) {
            return;
        }
        if (given->setup.empty()) {
            context.status =
                complain({"nothing to track", "track", "CONFIG, or begin, lenses, calibrate, pivot, print, measure"});
            return;
        }
        context.status = call_with_window<tracking::TrackEntry>(tracking::track_entry_name, *given, *window);
    });
}

}  // namespace rhexis::cli
