// SPDX-License-Identifier: GPL-3.0-or-later
// A person operates in a window: the simulation and the picture on threads of their own, the devices on this one.
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "render/image_file.hpp"
#include "render/renderer.hpp"
#include "station/early_thread.hpp"
#include "station/mapping.hpp"
#include "station/person.hpp"
#include "station/scripted.hpp"
#include "station/station.hpp"
#include "station/window/drawing.hpp"
#include "station/window/panels.hpp"
#include "station/window/window.hpp"

namespace rhexis::station {
namespace {

constexpr double event_wait_s = 0.005;  ///< for an event, before it is looked whether the trial has ended

/// What comes from the devices counts: a person's, or what is typed in a person's place.
bool operates(const StationOptions& options) { return !options.again && (options.by.empty() || options.typed); }

/// Until the trial has ended.
void look_on(const StationOptions& options, Desk& desk, Window& window, Drawing& drawing) {
    while (!desk.ended()) {
        for (const UserEvent& event : window.poll(event_wait_s)) {
            if (operates(options)) {
                drawing.take(event);
            } else if (event.kind == EventKind::quit) {
                desk.close();
            }
        }
        window.take_cursor(drawing.takes_cursor());
    }
    window.take_cursor(false);
}

/// What the window shows in the end.
Status keep_picture(const StationOptions& options, Desk& desk, Picture& picture) {
    const std::shared_ptr<Shown> last = desk.newest();
    if (options.screenshot.empty() || !last) {
        return success();
    }
    Image image;
    picture.draw(*last, {}, &image);
    return write_png(image, options.screenshot);
}

struct Prepared {
    std::string mapping_file;
    Mapping mapping;
    std::vector<MappingOffer> offers;
    std::string own;  ///< where a person's mapping is kept
    std::optional<EventFile> file;
    std::optional<EventWriter> writer;
    std::optional<Ghost> ghost;
};

nlohmann::json events_header(const StationOptions& options, const Mapping& mapping) {
    nlohmann::json header = options.begun_with;
    header["curriculum"] = options.attempt.exercise.curriculum;
    header["seed"] = options.attempt.exercise.seed;
    header["set"] = options.attempt.exercise.set;
    header["input"] = options.pad ? "gamepad" : "mouse";
    header["mapping"] = mapping.to_json();
    return header;
}

std::string setting_of(const StationOptions& options, const char* name) {
    const auto found = options.attempt.exercise.set.find(name);
    return found == options.attempt.exercise.set.end() ? "" : found->second;
}

/// The one that is named, else a person's own, else the standard one.
std::string mapping_file(const StationOptions& options) {
    const bool left = setting_of(options, "handedness") == "left";
    const std::string own = own_mapping(options.pad, left);
    std::error_code unknown;
    if (options.mapping.empty() && options.by.empty() && !own.empty() && std::filesystem::exists(own, unknown)) {
        return own;
    }
    return options.mapping.empty() ? standard_mapping(options.attempt.exercise.root, options.pad, left)
                                   : options.mapping;
}

Status offer_mappings(const StationOptions& options, Prepared& prepared) {
    for (const auto& [title, left] : {std::pair("Right-handed", false), {"Left-handed", true}}) {
        Result<Mapping> mapping = Mapping::read(standard_mapping(options.attempt.exercise.root, options.pad, left));
        if (!mapping) {
            return mapping.error();
        }
        prepared.offers.push_back({title, std::move(mapping).value()});
    }
    prepared.own = own_mapping(options.pad, setting_of(options, "handedness") == "left");
    return success();
}

Result<Prepared> prepare(const StationOptions& options) {
    Prepared prepared;
    prepared.mapping_file = mapping_file(options);
    if (const Status offered = offer_mappings(options, prepared); !offered) {
        return offered.error();
    }
    Result<Mapping> mapping = Mapping::read(prepared.mapping_file);
    if (options.again) {
        Result<EventFile> file = read_events(options.events);
        if (!file) {
            return file.error();
        }
        prepared.file = std::move(file).value();
        mapping = Mapping::from(prepared.file->header.value("mapping", nlohmann::json::object()));
    }
    if (!mapping) {
        return mapping.error();
    }
    prepared.mapping = std::move(mapping).value();
    if (!options.events.empty() && !options.again) {
        Result<EventWriter> writer = EventWriter::create(options.events, events_header(options, prepared.mapping));
        if (!writer) {
            return writer.error();
        }
        prepared.writer.emplace(std::move(writer).value());
    }
    return prepared;
}

/// No wall clock: each step waits for its picture, where it has one.
bool is_stepped(const StationOptions& options) { return options.again || (!options.by.empty() && !options.live); }

Result<std::unique_ptr<EventSource>> make_source(const StationOptions& options, const Prepared& prepared, Desk& desk,
                                                 const Window& window, double step_s) {
    if (options.again) {
        return std::unique_ptr<EventSource>(std::make_unique<Steps>(*prepared.file));
    }
    if (options.by.empty()) {
        return std::unique_ptr<EventSource>(std::make_unique<WallClock>(desk, step_s));
    }
    ExerciseOptions of_surgeon = options.attempt.exercise;
    of_surgeon.surgeon = options.by;
    std::unique_ptr<Typist> typist;
    if (options.typed) {
        Result<std::unique_ptr<Typist>> started = Typist::create(window.x_number(), window.width(), window.height());
        if (!started) {
            return started.error();
        }
        typist = std::move(started).value();
    }
    Result<std::unique_ptr<Scripted>> scripted = Scripted::create(
        of_surgeon, Fingers(options.pad ? Style::pad : Style::mouse, options.width, options.height, !options.typed),
        options.live ? std::make_unique<WallClock>(desk, step_s) : nullptr, std::move(typist));
    return scripted ? Result<std::unique_ptr<EventSource>>(std::move(scripted).value()) : scripted.error();
}

Result<AttemptResult> train(const StationOptions& options) {
    Result<Prepared> made = prepare(options);
    if (!made) {
        return made.error();
    }
    Prepared& prepared = made.value();
    const Result<ExerciseHost> host = ExerciseHost::load(options.attempt.exercise);
    if (!host) {
        return host.error();
    }
    const double step_s = host.value().scene().step_s;
    if (!options.ghost.empty()) {
        Result<Ghost> ghost = Ghost::read(options.ghost, host.value().scene().instruments);
        if (!ghost) {
            return ghost.error();
        }
        prepared.ghost.emplace(std::move(ghost).value());
    }
    EarlyThread simulation;
    step_back();
    Result<Window> window = Window::open("rhexis: " + host.value().identity().value("title", std::string()),
                                         options.width, options.height, options.full_screen);
    if (!window) {
        return window.error();
    }
    Result<Renderer> renderer = Renderer::create_in_window(window.value().width(), window.value().height());
    if (!renderer) {
        return renderer.error();
    }
    Result<HoldScript> holds = HoldScript::load(options.attempt.exercise.root);
    if (!holds) {
        return holds.error();
    }
    Result<Words> words =
        Words::load(options.attempt.exercise.root, setting_of(options, "language"), host.value().scene().instruments);
    if (!words) {
        return words.error();
    }
    Panels panels(window.value(), std::move(words).value(), std::move(prepared.offers), prepared.own);
    MappingFile mapping_file(prepared.mapping_file, prepared.mapping);
    Picture picture(window.value(), panels, std::move(renderer).value(), std::move(holds).value(),
                    {options.stereo, prepared.ghost ? &*prepared.ghost : nullptr, !is_stepped(options), step_s});
    Desk desk;
    Result<std::unique_ptr<EventSource>> made_source = make_source(options, prepared, desk, window.value(), step_s);
    if (!made_source) {
        return made_source.error();
    }
    const std::unique_ptr<EventSource> source = std::move(made_source).value();
    const PersonOptions of_person{prepared.mapping,
                                  options.pad ? "gamepad" : "mouse",
                                  options.attempt.exercise.root,
                                  static_cast<std::uint64_t>(options.picture_every),
                                  is_stepped(options),
                                  prepared.ghost.has_value()};
    Person person(of_person, *source, desk, prepared.writer ? &*prepared.writer : nullptr);
    AttemptOptions of_attempt = options.attempt;
    of_attempt.guest = &person;
    of_attempt.quiet = true;
    std::optional<Result<AttemptResult>> result;
    simulation.run([&] {
        result.emplace(attempt(of_attempt));
        desk.end();
    });
    {
        Drawing drawing(desk, window.value(), panels, mapping_file, picture, operates(options));
        look_on(options, desk, window.value(), drawing);
    }
    simulation.join();
    const Status pictured = keep_picture(options, desk, picture);
    if (!pictured) {
        return pictured.error();
    }
    if (!result->ok()) {
        return result->error();
    }
    const Status kept = prepared.writer ? prepared.writer->finish() : success();
    if (!kept) {
        return kept.error();
    }
    return std::move(*result).value();
}

}  // namespace
}  // namespace rhexis::station

extern "C" __attribute__((visibility("default"))) void rhexis_station_train(
    const rhexis::station::StationOptions& options, rhexis::Result<rhexis::AttemptResult>& result) {
    result = rhexis::station::train(options);
}
