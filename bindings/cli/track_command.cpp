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
    "  rhexis track my_rig/track.json --seconds 2 --picture seen.png    what the cameras saw, with what was made of "
    "it\n"
    "  rhexis track pivot my_rig/track.json phaco    where the tip is, by turning it about its tip\n"
    "  rhexis track measure --seeds 2             how accurate and how fast it is, beside what was aimed at\n"
    "  rhexis track print my_rig/phaco.json phaco.stl    posts and ring for the spheres, to print\n"
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
    command->callback(
        [given, &context] { context.status = call<tracking::CalibrateEntry>(tracking::calibrate_entry_name, *given); });
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
    auto folder = std::make_shared<std::string>();
    command->add_option("folder", *folder, "Empty, or not there yet")->required();
    command->callback(
        [folder, &context] { context.status = call<tracking::BeginEntry>(tracking::begin_entry_name, *folder); });
}

void add_measure(CLI::App& track, Context& context) {
    CLI::App* command = track.add_subcommand("measure", "What tracking reaches, on rigs without cameras drawn by seed");
    auto given = std::make_shared<tracking::MeasureOptions>();
    command->add_option("--first-seed", given->first_seed, "Of rig, calibration, clips and noise")
        ->capture_default_str();
    command->add_option("--seeds", given->seeds, "So many")->check(CLI::Range(1, 100))->capture_default_str();
    command->add_option("--image-seconds", given->image_s, "Of each clip that is rendered")
        ->check(CLI::Range(0.1, 60.0))
        ->capture_default_str();
    command->add_option("--marker-seconds", given->marker_s, "Of moving clips without images")
        ->check(CLI::Range(0.5, 600.0))
        ->capture_default_str();
    command->add_option("--identities", given->identity_frames, "Exposures in which a wrong body is looked for")
        ->check(CLI::Range(100, 10000000))
        ->capture_default_str();
    command->add_flag("!--no-chart", given->chart, "Without the chart of detectors");
    command->add_flag("--json", given->json, "As JSON");
    command->callback(
        [given, &context] { context.status = call<tracking::MeasureEntry>(tracking::measure_entry_name, *given); });
}

void add_print(CLI::App& track, Context& context) {
    CLI::App* command = track.add_subcommand("print", "Posts and ring for a body's spheres, as an STL file");
    auto body = std::make_shared<std::string>();
    auto stl = std::make_shared<std::string>();
    command->add_option("body", *body, "The body's file")->required();
    command->add_option("stl", *stl, "File to write")->required();
    command->callback([body, stl, &context] {
        context.status = call<tracking::PrintEntry>(tracking::print_entry_name, *body, *stl);
    });
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
    add_print(*command, context);
    add_measure(*command, context);
    command->callback([given, command, &context] {
        if (!command->get_subcommands().empty()) {
            return;
        }
        if (given->setup.empty()) {
            context.status =
                complain({"nothing to track", "track", "CONFIG, or begin, lenses, calibrate, pivot, print, measure"});
            return;
        }
        context.status = call<tracking::TrackEntry>(tracking::track_entry_name, *given);
    });
}

}  // namespace rhexis::cli
