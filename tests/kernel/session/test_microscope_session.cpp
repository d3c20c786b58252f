// SPDX-License-Identifier: GPL-3.0-or-later
// A session whose scene names the microscope: what it has more, what it refuses, and that a recording replays.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "kernel/session/sessions.hpp"
#include "session/prepared_state.hpp"
#include "support/sample.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

SceneDescription scene_with(std::vector<std::string> instruments) {
    SceneDescription scene;
    scene.tissues = {"iris", "cornea"};
    scene.instruments = std::move(instruments);
    return scene;
}

double measure(const Session& session, const std::string& name) {
    for (std::size_t i = 0; i < session.schema().size(); ++i) {
        if (session.schema()[i].name == name) {
            return session.observation().values[i];
        }
    }
    FAIL("no measure " << name);
    return 0.0;
}

DeviceSample sent_to(const Vec3& place) { return sample_at(1, place); }

const SceneDescription with_microscope = scene_with({"probe", "microscope"});

}  // namespace

TEST_SUITE("microscope session") {
    TEST_CASE("it stands at first where its settings say, and is no tool") {
        SceneDescription scene = with_microscope;
        scene.settings = {{"microscope.x_mm", 3.0}, {"microscope.y_mm", -4.0}, {"microscope.focus_mm", -2.0}};
        const Session session = make_session(scene);
        CHECK(session.tools().size() == 1);
        CHECK(measure(session, "microscope.pupil_offset") == doctest::Approx(5.0 / 7.3));
        CHECK(measure(session, "microscope.pupil_in_view") == 0.0);
        CHECK(measure(session, "microscope.defocus_mm") == doctest::Approx(-2.0));
        CHECK(measure(session, "microscope.in_focus") == 0.0);
        CHECK(session.frame().microscope.has_value());
        CHECK(session.percept().field.has_value());
    }

    TEST_CASE("a scene that does not name it has none of it") {
        const Session session = make_session(scene_with({"probe"}));
        CHECK_FALSE(session.state().microscope.has_value());
        CHECK_FALSE(session.frame().microscope.has_value());
        CHECK_FALSE(session.percept().field.has_value());
        CHECK(std::none_of(session.schema().begin(), session.schema().end(), [](const MeasureInfo& info) {
            return info.name.rfind("microscope.", 0) == 0 || info.name == "instruments.out_s";
        }));
    }

    TEST_CASE("its place among the instruments, the iris and its settings are checked") {
        CHECK(refusal(scene_with({"microscope", "probe"})) == "instruments names microscope before probe (last)");
        SceneDescription scene = with_microscope;
        scene.tissues = {"cornea"};
        CHECK(refusal(scene).find("instruments names microscope, but tissues no iris") == 0);
        scene = with_microscope;
        scene.settings = {{"microscope.x_mm", 5.0}};
        CHECK(refusal(scene) == "settings.microscope.x_mm is 5 (-4 to 4)");
        scene.settings = {{"microscope.focus_mm", std::numeric_limits<double>::quiet_NaN()}};
        CHECK(refusal(scene) == "settings.microscope.focus_mm is nan (-8 to 8)");
    }

    TEST_CASE("it goes where it is sent; what makes no sense is refused once, in one line, and it stays") {
        Session session = make_session(with_microscope);
        const Vec3 before = session.state().microscope->position;
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e9, 40.0}) {
            const DeviceSample sample = sent_to(Vec3(bad, 0.0, 0.0));
            session.step({&sample, 1}, {});
            CHECK(session.state().microscope->position == before);
        }
        CHECK(session.log().size() == 1);
        const DeviceSample unknown = sample_at(2, Vec3::Zero());
        session.step({&unknown, 1}, {});
        CHECK(session.log().back().text.find("instrument is 2 (0 to 1)") != std::string::npos);
        const DeviceSample good = sent_to(Vec3(0.0, 0.0, session.eye().anatomy.iris_z));
        for (int i = 0; i < 101; ++i) {
            session.step({&good, 1}, {});
        }
        CHECK(session.state().microscope->position == good.pose.position);
        CHECK(measure(session, "microscope.pupil_offset") == 0.0);
        CHECK(measure(session, "microscope.in_focus") == 1.0);
        session.step({}, {});  // the foot is off the pedal
        CHECK(session.state().microscope->position == good.pose.position);
    }

    TEST_CASE("where it stands is a part of the state's hash") {
        SceneDescription other = with_microscope;
        Session a = make_session(with_microscope);
        Session b = make_session(other);
        CHECK(a.state_hash() == b.state_hash());
        const DeviceSample sample = sent_to(Vec3::Zero());
        a.step({&sample, 1}, {});
        b.step({}, {});
        CHECK(a.state_hash() != b.state_hash());
    }

    TEST_CASE("a recording of it replays step by step, and can be entered in between") {
        Session session = make_session(with_microscope);
        SessionRecorder recorder(session);
        const std::uint64_t steps = recorder.interval() + 20;
        while (session.step_count() < steps) {
            recorder.step(sent_to(Vec3(session.step_count() < 300 ? -3.0 : 3.0, 0.5, 2.0)));
        }
        const Recording recording = recorder.finish();
        CHECK(recording.steps.size() == steps);
        check_replays(recording, {40, recorder.interval() + 10});
    }

    TEST_CASE("a run from a state has its microscope where its own settings say") {
        const Folder folder;
        const std::string path = folder / "moved.rhxs";
        Session made = make_session(with_microscope);
        const Vec3 start = made.state().microscope->position;
        const DeviceSample sample = sent_to(Vec3::Zero());
        made.step({&sample, 1}, {});
        REQUIRE(write_state(path, {header_of(made), made.copy_state()}).ok());
        const Result<Session> from = create_session(with_microscope, 1, path);
        REQUIRE(from.ok());
        CHECK(from.value().state().microscope->position == start);
    }

    TEST_CASE("a snapshot without it, or with a position that is no number, does not fit") {
        Session session = make_session(with_microscope);
        Snapshot snapshot = session.snapshot();
        snapshot.world.microscope->position.x() = std::numeric_limits<double>::quiet_NaN();
        CHECK(session.restore(snapshot).error().text().find("the microscope does not fit the scene") !=
              std::string::npos);
        snapshot.world.microscope.reset();
        CHECK_FALSE(session.restore(snapshot).ok());
    }
}
