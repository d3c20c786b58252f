// SPDX-License-Identifier: GPL-3.0-or-later
// A person operates in a window: the simulation and the picture on threads of their own, the devices on this one.
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "station/person.hpp"
#include "station/scripted.hpp"
#include "station/station.hpp"
#include "station/tracked_source.hpp"
#include "station/window/cut_short.hpp"
#include "station/window/drawing_thread.hpp"
#include "station/window/prepared.hpp"
#include "station/window/sound.hpp"
#include "station/window/window.hpp"
#include "station/window/x_number.hpp"
#include "theatre/link.hpp"

namespace rhexis::station {
namespace {

constexpr double event_wait_s = 0.005;  ///< for an event, before it is looked whether the trial has ended

/// What there is besides the window.
struct Around {
    std::unique_ptr<TheatreFeed> theatre{};  ///< null: no monitor is fed
    std::unique_ptr<Sound> sound{};          ///< null: there is no loudspeaker, or none is wanted
    std::string notice{};                    ///< to be shown
};

Result<Around> make_around(const StationOptions& options) {
    Around around;
    if (!options.theatre.empty()) {
        Result<std::unique_ptr<TheatreFeed>> opened = TheatreFeed::open(options.theatre);
        if (!opened) {
            return opened.error();
        }
        around.theatre = std::move(opened).value();
    }
    if (!options.silent && !is_stepped(options)) {
        Result<std::unique_ptr<Sound>> opened = Sound::open();
        around.sound = opened ? std::move(opened).value() : nullptr;
        around.notice = opened ? "" : opened.error().text();
    }
    return around;
}

/// Until the trial has ended.
void look_on(const StationOptions& options, Desk& desk, Window& window, DrawingThread& drawing, const Around& around) {
    while (!desk.ended()) {
        if (around.sound) {
            around.sound->tell(desk.heard());
        }
        if (around.theatre && !options.again) {
            desk.post(around.theatre->requests());
        }
        for (const UserEvent& event : window.poll(event_wait_s)) {
            if (operates(options)) {
                drawing.take(event);
            } else if (event.kind == EventKind::quit) {
                desk.close();
            }
        }
        window.take_cursor(drawing.takes_cursor());
    }
    if (around.sound) {
        around.sound->tell({});
    }
    window.take_cursor(false);
}

Result<std::unique_ptr<EventSource>> make_tracked(const StationOptions& options, const Prepared& prepared, Desk& desk) {
    Result<std::unique_ptr<TrackedSource>> made = TrackedSource::create(
        desk, {options.tracked_at, options.registration, prepared.instruments}, {.step_s = prepared.step_s});
    return made ? Result<std::unique_ptr<EventSource>>(std::move(made).value()) : made.error();
}

Result<std::unique_ptr<EventSource>> make_source(const StationOptions& options, const Prepared& prepared, Desk& desk,
                                                 const Window& window) {
    const double step_s = prepared.step_s;
    if (options.again) {
        return std::unique_ptr<EventSource>(std::make_unique<Steps>(*prepared.file));
    }
    if (options.tracked) {
        return make_tracked(options, prepared, desk);
    }
    if (options.by.empty()) {
        return std::unique_ptr<EventSource>(std::make_unique<WallClock>(desk, step_s));
    }
    ExerciseOptions of_surgeon = options.attempt.exercise;
    of_surgeon.surgeon = options.by;
    std::unique_ptr<Typist> typist;
    if (options.typed) {
        Result<std::unique_ptr<Typist>> started =
            Typist::create(x_number(window.handle()), window.width(), window.height());
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

/// On this thread devices, on others the simulation and the pictures.
Result<AttemptResult> operate(const StationOptions& options, Person& person, Desk& desk, Window& window,
                              DrawingThread& drawing, const Around& around) {
    AttemptOptions of_attempt = options.attempt;
    of_attempt.guest = &person;
    of_attempt.quiet = true;
    const CutShort cut_short(options.attempt.folder);
    std::optional<Result<AttemptResult>> result;
    std::thread simulation([&] {
        result.emplace(attempt(of_attempt));
        desk.end();
    });
    look_on(options, desk, window, drawing, around);
    simulation.join();
    const Status pictured = drawing.finish();
    return pictured || !result->ok() ? std::move(*result) : pictured.error();
}

Result<AttemptResult> train(const StationOptions& options) {
    Result<Prepared> made = prepare(options);
    if (!made) {
        return made.error();
    }
    Prepared& prepared = made.value();
    Result<Window> window =
        Window::open("rhexis: " + prepared.title, options.width, options.height, options.full_screen);
    if (!window) {
        return window.error();
    }
    Result<Around> around = make_around(options);
    if (!around) {
        return around.error();
    }
    Desk desk;
    Result<std::unique_ptr<EventSource>> source = make_source(options, prepared, desk, window.value());
    if (!source) {
        return source.error();
    }
    DrawingThread drawing(desk, window.value(), prepared, options, around.value().notice);
    if (const Status begun = drawing.begun(); !begun) {
        return begun.error();
    }
    const PersonOptions of_person{prepared.mapping,
                                  device_of(options),
                                  options.attempt.exercise.root,
                                  static_cast<std::uint64_t>(options.picture_every),
                                  is_stepped(options),
                                  prepared.ghost.has_value(),
                                  options.warns,
                                  prepared.title,
                                  around.value().sound != nullptr};
    Person person(of_person, *source.value(), desk, prepared.writer ? &*prepared.writer : nullptr,
                  around.value().theatre.get());
    Result<AttemptResult> result = operate(options, person, desk, window.value(), drawing, around.value());
    const Status kept = result.ok() && prepared.writer ? prepared.writer->finish() : success();
    return kept ? std::move(result) : kept.error();
}

}  // namespace
}  // namespace rhexis::station

extern "C" __attribute__((visibility("default"))) void rhexis_station_train(
    const rhexis::station::StationOptions& options, rhexis::Result<rhexis::AttemptResult>& result) {
    result = rhexis::station::train(options);
}
