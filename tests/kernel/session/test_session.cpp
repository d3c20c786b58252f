// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <xmmintrin.h>

#include <algorithm>
#include <limits>

#include "kernel/session/operate.hpp"
#include "session/settings.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_SUITE("session") {
    TEST_CASE("a wrong field of the scene is named with its value and its range") {
        SceneDescription scene = small_scene();
        scene.patient.age = 12.0;
        CHECK(refusal(scene) == "patient.age is 12 (20 to 95)");
        scene = small_scene();
        scene.patient.pupil_mm = not_a_number;
        CHECK(refusal(scene) == "patient.pupil_mm is nan (3 to 9)");
        scene = small_scene();
        scene.step_s = 0.05;
        CHECK(refusal(scene) == "step_s is 0.05 (0.001 to 0.02)");
        scene = small_scene();
        scene.tissues.push_back("retina");
        CHECK(refusal(scene).find("tissues names retina") == 0);
        scene = small_scene();
        scene.instruments = {"phaco", "phaco"};
        CHECK(refusal(scene) == "instruments names phaco twice (each once)");
        scene = small_scene();
        scene.instruction_set = "axv2";
        CHECK(refusal(scene) == "instruction_set is axv2 (did you mean avx2?)");
        scene = small_scene();
        scene.settings["phaco.power_limit"] = 1.5;
        CHECK(refusal(scene) == "settings.phaco.power_limit is 1.5 (0 to 1)");
        scene.settings = {{"phaco.powr_limit", 0.5}};
        CHECK(refusal(scene) == "settings: there is no setting phaco.powr_limit (did you mean phaco.power_limit?)");
    }

    TEST_CASE("two sessions stepped in turn end as each does alone") {
        SceneDescription other = small_scene();
        other.patient.age = 80.0;
        Session alone_a = make_session();
        Session alone_b = make_session(other, 2);
        const std::vector<std::uint64_t> a = hashes_of(alone_a, 40);
        const std::vector<std::uint64_t> b = hashes_of(alone_b, 40);
        Session turn_a = make_session();
        Session turn_b = make_session(other, 2);
        for (int i = 0; i < 40; ++i) {
            operate(turn_a, 1);
            operate(turn_b, 1);
            REQUIRE(turn_a.state_hash() == a[i]);
            REQUIRE(turn_b.state_hash() == b[i]);
        }
        CHECK(a.back() != b.back());
    }

    TEST_CASE("one thread and two threads end in the same state") {
        SceneDescription two = small_scene();
        two.threads = 2;
        Session one_thread = make_session();
        Session two_threads = make_session(two);
        CHECK(hashes_of(one_thread, 40) == hashes_of(two_threads, 40));
    }

    TEST_CASE("going on from a snapshot equals running through") {
        Session session = make_session();
        operate(session, 25);
        const Snapshot snapshot = session.snapshot();
        const std::uint64_t before = session.state_hash();
        const std::vector<std::uint64_t> through = hashes_of(session, 20);
        REQUIRE(session.restore(snapshot).ok());
        CHECK(session.state_hash() == before);
        CHECK(hashes_of(session, 20) == through);
        Session fresh = make_session();
        REQUIRE(fresh.restore(snapshot).ok());
        CHECK(hashes_of(fresh, 20) == through);
    }

    TEST_CASE("a session goes on from a snapshot in which a tip lies against the lens") {
        Session session = make_session();
        DeviceSample sample;
        sample.present = true;
        const int vertices = static_cast<int>(session.world().solids[0].coarse.nodes.size() +
                                              session.world().solids[0].fine.edges.size());
        const auto by_point = [&](const ContactMemory& memory) { return memory.vertex >= vertices; };
        bool touches = false;
        for (int i = 0; i < 100 && !touches; ++i) {
            sample.pose.position = Vec3(0.0, -1.0, 2.5 - 0.02 * i);
            session.step({&sample, 1}, {});
            const std::vector<ContactMemory>& memory = session.state().memory;
            touches = std::any_of(memory.begin(), memory.end(), by_point);
        }
        REQUIRE(touches);
        const Snapshot snapshot = session.snapshot();
        Session fresh = make_session();
        REQUIRE(fresh.restore(snapshot).ok());
        for (int i = 0; i < 10; ++i) {
            session.step({&sample, 1}, {});
            fresh.step({&sample, 1}, {});
        }
        CHECK(fresh.state_hash() == session.state_hash());
    }

    TEST_CASE("a snapshot of another scene is refused and changes nothing") {
        SceneDescription larger = small_scene();
        larger.patient.tetrahedra = 900;
        const Session other = make_session(larger);
        Session session = make_session();
        const std::uint64_t before = session.state_hash();
        const Status status = session.restore(other.snapshot());
        REQUIRE_FALSE(status.ok());
        CHECK(status.error().text().find("snapshot") == 0);
        CHECK(session.state_hash() == before);
        operate(session, 1);
        CHECK(session.step_count() == 1);
    }

    TEST_CASE("a sample with a number that makes no sense leaves the instrument as it was") {
        Session session = make_session();
        operate(session, 3);
        const Vec3 before = session.tools()[0].pose.position;
        DeviceSample broken = hand_at(session, 0.5);
        broken.pose.position.y() = not_a_number;
        session.step({&broken, 1}, {});
        session.step({&broken, 1}, {});
        CHECK(session.tools()[0].pose.position == before);
        REQUIRE(session.log().size() == 1);  // once for a device that stays broken
        CHECK(session.log()[0].text.find("pose.position.y is nan (-200 to 200)") != std::string::npos);
        broken = hand_at(session, 0.5);
        broken.pedal = 7.0;
        session.step({&broken, 1}, {});
        broken = hand_at(session, 0.5);
        broken.instrument = 3;
        session.step({&broken, 1}, {});
        CHECK(session.tools()[0].pose.position == before);
        CHECK(session.log().back().text.find("instrument is 3 (0 to 0)") != std::string::npos);
        operate(session, 1);
        CHECK(session.tools()[0].pose.position != before);
    }

    TEST_CASE("a command outside its range is refused, logged and without effect") {
        Session session = make_session();
        Session quiet = make_session();
        const std::vector<Command> commands{{CommandKind::set, "phaco.power_limit", 3.0, ""},
                                            {CommandKind::set, "phaco.power", 0.5, ""},
                                            {CommandKind::set, "zonules.strength", 0.5, ""}};
        session.step({}, commands);
        quiet.step({}, {});
        CHECK(session.state_hash() == quiet.state_hash());
        REQUIRE(session.log().size() == 3);
        CHECK(session.log()[0].text == "command refused: settings.phaco.power_limit is 3 (0 to 1)");
        CHECK(session.log()[2].text.find("only be set before the first step") != std::string::npos);
    }

    TEST_CASE("a command in its range changes the state") {
        Session session = make_session();
        Session quiet = make_session();
        const std::vector<Command> commands{{CommandKind::set, "phaco.power_limit", 0.5, ""}};
        session.step({}, commands);
        quiet.step({}, {});
        CHECK(session.state_hash() != quiet.state_hash());
        CHECK(session.log().empty());
    }

    TEST_CASE("a step leaves the processor's handling of denormals as it was") {
        Session session = make_session();
        const unsigned before = _mm_getcsr();
        operate(session, 2);
        CHECK(_mm_getcsr() == before);
        volatile double tiny = std::numeric_limits<double>::min();
        tiny = tiny / 4.0;
        CHECK(tiny > 0.0);
    }

    TEST_CASE("the seed is part of the state") {
        CHECK(make_session(small_scene(), 1).state_hash() != make_session(small_scene(), 2).state_hash());
    }

    TEST_CASE("what the scene does not name is neither built nor measured") {
        SceneDescription scene = small_scene();
        scene.tissues = {"iris"};
        const Session session = make_session(scene);
        CHECK(session.world().solids.empty());
        CHECK(session.world().bags.empty());
        CHECK(session.frame().eye->has_iris);
        CHECK_FALSE(session.frame().eye->has_cornea);
        for (const MeasureInfo& info : session.schema()) {
            CHECK(info.name.find("lens.") != 0);
            CHECK(info.name.find("groove.") != 0);
        }
    }

    TEST_CASE("every setting's standard value lies in its range") {
        for (const SettingInfo& info : setting_table()) {
            CHECK(check_setting(info.name, info.standard).ok());
            CHECK_FALSE(check_setting(info.name, info.maximum + 1.0).ok());
        }
    }
}
