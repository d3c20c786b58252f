// SPDX-License-Identifier: GPL-3.0-or-later
// The station's threads as in the window, without a window: one reads devices, one simulates by the wall clock, one
// looks at pictures. What they make is checked elsewhere; built with the thread sanitizer (scripts/dev/threads.sh) it
// is shown that they do not get into each other's way.
#include <doctest/doctest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

#include "station/event_source.hpp"
#include "station/person.hpp"
#include "trial/starts.hpp"

using namespace rhexis;
using namespace rhexis::station;

namespace {

constexpr double simulated_s = 1.5;

/// Draws nothing: what the drawing thread does to hands and frame before it does.
void look_at_pictures(Desk& desk) {
    Result<HoldScript> holds = HoldScript::load(".");
    std::optional<std::uint64_t> seen;
    while (holds.ok() && !desk.ended()) {
        const std::shared_ptr<Shown> shown = desk.wait_for(seen, 0.02);
        if (!shown) {
            continue;
        }
        Hands hands(shown->hands, *shown->stand, holds.value());
        for (const UserEvent& event : desk.after(shown->events)) {
            hands.take(event, shown->around);
        }
        static_cast<void>(hands.advance(shown->around, 0.01));
        if (!hands.samples(shown->around, 0.01).empty() && !shown->frame.tools.empty()) {
            shown->frame.tools[0].jaw = hands.state().hands[0].jaw;
        }
        seen = shown->step;
        desk.drawn(*seen);
    }
}

/// A hand that takes an instrument and moves it to and fro, and a foot.
void work_devices(Desk& desk) {
    for (const char* key : {"E", "F", "2"}) {
        desk.post({EventKind::key, key, 1.0});
        desk.post({EventKind::key, key, 0.0});
    }
    for (int i = 0; !desk.ended(); ++i) {
        desk.post({EventKind::pointer, "", 0.0, 0.02 * std::sin(0.1 * i), 0.001 * i});
        desk.post({EventKind::wheel, "", i % 2 == 0 ? 1.0 : -1.0});
        if (i % 50 == 49) {
            desk.post({EventKind::bind, "tuning.fine", 0.2 + 0.001 * i});
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

}  // namespace

TEST_CASE("devices, simulation and pictures each have a thread") {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("rhexis_threads_" + std::to_string(::getpid()));
    AttemptOptions options;
    options.exercise = {"curricula/groove", "none", 1, {{"patient.tetrahedra", "500"}, {"input", "mouse"}}, "."};
    options.folder = folder.string();
    options.drawing = Drawing::none;
    options.limit_s = simulated_s;
    options.quiet = true;
    Result<Start> start = find_start({"curricula/groove", "", options.exercise.set, ".", false, ""});
    REQUIRE(start.ok());
    options.start = std::move(start).value();
    Result<Mapping> mapping = Mapping::read(standard_mapping(".", false, false));
    REQUIRE(mapping.ok());
    Desk desk;
    WallClock clock(desk, 0.01);
    Person person({mapping.value(), "mouse", ".", 1, false, false}, clock, desk, nullptr);
    options.guest = &person;
    std::optional<Result<AttemptResult>> result;
    std::thread simulation([&] {
        result.emplace(attempt(options));
        desk.end();
    });
    std::thread pictures([&] { look_at_pictures(desk); });
    work_devices(desk);
    pictures.join();
    simulation.join();
    REQUIRE(result->ok());
    CHECK(result->value().facts.duration_s == doctest::Approx(simulated_s));
    CHECK(std::filesystem::exists(folder / "recording.rhx"));
    std::filesystem::remove_all(folder);
}
