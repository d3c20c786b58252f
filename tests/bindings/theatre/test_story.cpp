// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "theatre/debriefing/free_camera.hpp"
#include "theatre/debriefing/story.hpp"
#include "theatre/monitor/traces.hpp"

using namespace rhexis;
using namespace rhexis::station;

TEST_CASE("what an exercise found becomes marks by time, and items with what would have been a four") {
    const nlohmann::json result = nlohmann::json::parse(R"({"title": "Demo",
        "events": [{"title": "Touched", "advice": "Away.", "time_s": 7, "recovery_s": 2}],
        "warnings": [{"title": "Near", "advice": "Up.", "time_s": 5}],
        "notes": [{"text": "look here", "time_s": 6}],
        "aids": [{"id": "slowed", "seconds": 2}, {"id": "injected", "told": [{"text": "A cough", "time_s": 3}]}],
        "steps": [{"title": "One", "start_s": 0}, {"title": "Two"}],
        "osacss": {"total": 7, "max": 10, "items": [
            {"id": "T1", "name": "First", "score": 2, "reasons": ["Too long."],
             "to_four": {"errors": [{"text": "Without it."}], "measures": [{"text": "3 instead of 5."}]}},
            {"id": "T2", "name": "Second", "reasons": ["Not scored."]}]}})");
    const Story story = story_of(result);
    REQUIRE(story.marks.size() == 6);
    const MarkKind kinds[] = {MarkKind::step, MarkKind::injected, MarkKind::warning,
                              MarkKind::note, MarkKind::error,    MarkKind::put_right};
    for (std::size_t i = 0; i < story.marks.size(); ++i) {
        CHECK(story.marks[i].kind == kinds[i]);
    }
    CHECK(story.marks.back().time_s == 9.0);
    REQUIRE(story.items.size() == 2);
    CHECK(story.items[0].to_four == std::vector<std::string>{"Without it.", "3 instead of 5."});
    CHECK(story.items[1].score < 0.0);
    CHECK(story_of(nlohmann::json::object()).marks.empty());
}

TEST_CASE("the free camera goes round what the microscope looks at, and back") {
    FreeCamera camera;
    const Camera microscope;
    CHECK(camera.of(microscope).eye == microscope.eye);
    camera.turn(30.0, 20.0);
    camera.zoom(2.0);
    const Camera free = camera.of(microscope);
    CHECK((free.eye - free.target).norm() == doctest::Approx((microscope.eye - microscope.target).norm()));
    CHECK(std::abs((free.eye - free.target).normalized().dot(free.up)) < 1e-12);
    CHECK(free.field_mm == doctest::Approx(0.5 * microscope.field_mm));
    const double cosine = (free.eye - free.target).normalized().z();
    CHECK(cosine == doctest::Approx(std::cos(30.0 * 3.14159265 / 180.0) * std::cos(20.0 * 3.14159265 / 180.0)));
    camera.turn(1000.0, 0.0);
    CHECK((camera.of(microscope).eye - microscope.target).z() > 0.0);
    camera.reset();
    CHECK_FALSE(camera.is_free());
}

TEST_CASE("the heart on the monitor beats as often as it says, between moments too") {
    Traces traces;
    for (int i = 0; i <= 60; ++i) {  // ten moments a second, 90 beats a minute
        const double time_s = 0.1 * i;
        traces.add(time_s, {90.0, 140.0, 80.0, 97.0, std::fmod(1.5 * time_s, 1.0)});
    }
    int beats = 0;
    double before = 0.0;
    for (const Traces::Sample& sample : traces.samples()) {
        beats += sample.beat < before ? 1 : 0;
        before = sample.beat;
    }
    CHECK(beats >= 8);  // the ninth ends with the last sample, or just after it
    CHECK(beats <= 9);
    CHECK(traces.samples().back().time_s - traces.samples().front().time_s == doctest::Approx(6.0).epsilon(0.01));
    traces.add(1.0, {90.0, 140.0, 80.0, 97.0, 0.0});  // the attempt went back
    CHECK(traces.samples().back().time_s <= 1.0);
    double highest = 0.0;
    for (double beat = 0.0; beat < 1.0; beat += 0.01) {
        highest = std::max(highest, ecg_at(beat));
        CHECK(std::abs(pulse_at(beat) - 0.5) < 0.6);
    }
    CHECK(highest > 0.9);
}
