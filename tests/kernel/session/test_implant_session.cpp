// SPDX-License-Identifier: GPL-3.0-or-later
// A session with a foldable lens: built, unfolding, written, read and replayed to the same bits.
#include <doctest/doctest.h>

#include <limits>

#include "kernel/session/sessions.hpp"
#include "scenes/shells.hpp"
#include "session/codec.hpp"
#include "session/state_hash.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

SceneDescription implant_scene() {
    SceneDescription scene;
    scene.tissues = {"implant", "cornea"};
    scene.instruments = {"probe"};
    return scene;
}

/// Folded for long, and a pull on one of its edges.
Snapshot folded(const Session& session, int triangles = 743) {
    Snapshot snapshot = session.copy_state();
    const scenes::FoldedOptic optic = scenes::folded_optic(triangles);
    ShellState& shell = snapshot.world.shells[0];
    const std::vector<double> branch = shell.branch;
    shell = scenes::folded_state(optic, 3e4);
    shell.branch = branch;
    shell.loads.push_back({{optic.edge}, Vec3(0.0, 0.0, 50.0)});
    return snapshot;
}

std::uint64_t hash_of(const Snapshot& snapshot) {
    return hash_state(snapshot.world, snapshot.tools, snapshot.settings, snapshot.observer_memory, snapshot.step, 1);
}

void step(Session& session) {
    const DeviceSample away;
    session.step({&away, 1}, {});
}

}  // namespace

TEST_SUITE("implant session") {
    TEST_CASE("one shell is built, which sags a little under its weight and stays") {
        Session session = make_session(implant_scene());
        REQUIRE(session.world().shells.size() == 1);
        CHECK(session.world().shells[0].relaxation.has_value());
        CHECK(session.world().membranes.empty());
        CHECK(session.world().solids.empty());
        for (int i = 0; i < 50; ++i) {
            step(session);
        }
        double lowest = 0.0;
        for (const Vec3& x : session.state().shells[0].position) {
            CHECK(x.allFinite());
            lowest = std::min(lowest, x.z());
        }
        CHECK(lowest < -1e-4);
        CHECK(lowest > -1.0);
        CHECK(session.frame().shells[0].position == session.state().shells[0].position);
        SceneDescription both = implant_scene();
        both.tissues.emplace_back("lens");
        CHECK(refusal(both).find("implant with lens") != std::string::npos);
    }

    TEST_CASE("with the tissue bag its wall is a membrane, and nothing else of the bag is built") {
        SceneDescription scene = implant_scene();
        scene.tissues.emplace_back("bag");
        CHECK(refusal(scene).find("instruments no injector") != std::string::npos);
        scene.instruments = {"injector"};
        const Session session = make_session(scene);
        REQUIRE(session.world().membranes.size() == 1);
        CHECK(session.world().membranes[0].name == empty_bag_name);
        CHECK(session.world().bags.empty());
        CHECK(session.world().solids.empty());
        CHECK(session.state().shells[0].loaded);  // flat, it would reach through the wall
        scene.tissues.emplace_back("capsule");
        CHECK(refusal(scene).find("implant with capsule") != std::string::npos);
    }

    TEST_CASE("written and read it is the same, and every part of it counts in the state hash") {
        const Session session = make_session(implant_scene());
        const Snapshot whole = folded(session);
        const std::optional<Snapshot> back = decode_snapshot(encode(whole));
        REQUIRE(back);
        CHECK(hash_of(*back) == hash_of(whole));
        CHECK(back->world.shells[0].branch == whole.world.shells[0].branch);
        const auto differs = [&](const auto& change) {
            Snapshot other = whole;
            change(other.world.shells[0]);
            CHECK(hash_of(other) != hash_of(whole));
        };
        differs([](ShellState& s) { s.position[3].x() += 1e-9; });
        differs([](ShellState& s) { s.rotation[3].x() += 1e-9; });
        differs([](ShellState& s) { s.velocity[3].x() += 1e-9; });
        differs([](ShellState& s) { s.spin[3].x() += 1e-9; });
        differs([](ShellState& s) { s.branch[3] += 1e-9; });
        differs([](ShellState& s) { s.loads[0].nodes[0] += 1; });
        differs([](ShellState& s) { s.loads[0].total.x() += 1e-9; });
        differs([](ShellState& s) { s.loads.clear(); });
        for (double PlungerState::*part : {&PlungerState::pushed, &PlungerState::force, &PlungerState::stiffness}) {
            Snapshot other = whole;
            other.world.plungers[0].*part = 1.0;
            CHECK(hash_of(other) != hash_of(whole));
            CHECK(hash_of(*decode_snapshot(encode(other))) == hash_of(other));
        }
        const std::string bytes = encode(whole);
        for (std::size_t cut = 0; cut + 1 < bytes.size(); cut += 9973) {
            CHECK_FALSE(decode_snapshot(std::string_view(bytes).substr(0, cut)));
        }
    }

    TEST_CASE("what is no state of the shell is not restored") {
        Session session = make_session(implant_scene());
        const Snapshot whole = folded(session);
        const auto refused = [&](const auto& change) {
            Snapshot other = whole;
            change(other.world);
            CHECK_FALSE(session.restore(other).ok());
        };
        refused([](WorldState& w) { w.shells.clear(); });
        refused([](WorldState& w) { w.shells[0].position.pop_back(); });
        refused([](WorldState& w) { w.shells[0].branch.pop_back(); });
        refused([](WorldState& w) { w.shells[0].branch[0] = std::numeric_limits<double>::quiet_NaN(); });
        refused([](WorldState& w) { w.shells[0].rotation[0] = Quat(2.0, 0.0, 0.0, 0.0); });
        refused([](WorldState& w) { w.shells[0].loads[0].nodes[0] = 100000; });
        refused([](WorldState& w) { w.shells[0].loads[0].nodes.clear(); });
        refused([](WorldState& w) { w.plungers.clear(); });
        refused([](WorldState& w) { w.plungers[0].pushed = std::numeric_limits<double>::quiet_NaN(); });
        CHECK(session.restore(whole).ok());
    }

    TEST_CASE(
        "a recording of it unfolding simulates to the same hashes, from any checkpoint, on every instruction set") {
        SceneDescription scene = implant_scene();
        scene.step_s = 0.02;
        scene.settings["implant.triangles"] = 400.0;  // sanitized it takes long
        Session session = make_session(scene);
        REQUIRE(session.restore(folded(session, 400)).ok());
        SessionRecorder recorder(session);
        recorder.add_checkpoint();
        const std::uint64_t interval = recorder.interval();
        const std::uint64_t steps = interval + 12;
        while (session.step_count() < steps) {
            recorder.step(DeviceSample{});
        }
        Recording recording = recorder.finish();
        CHECK(recording.steps.size() == steps);
        check_replays(recording, {4, interval, interval + 1, steps});
        recording.header.scene.instruction_set = "baseline";
        check_replays(recording, {});
    }

    TEST_CASE("let go it unfolds, and goes on from a snapshot as it would have") {
        Session session = make_session(implant_scene());
        REQUIRE(session.restore(folded(session)).ok());
        const scenes::FoldedOptic optic = scenes::folded_optic(743);
        const double start = scenes::fold_degrees(optic, session.state().shells[0]);
        for (int i = 0; i < 10; ++i) {
            step(session);
        }
        const double now = scenes::fold_degrees(optic, session.state().shells[0]);
        CHECK(now < 0.95 * start);
        CHECK(now > 0.5 * start);
        const Snapshot kept = session.snapshot();
        Session other = make_session(implant_scene());
        REQUIRE(other.restore(kept).ok());
        for (int i = 0; i < 5; ++i) {
            step(session);
            step(other);
            CHECK(session.state_hash() == other.state_hash());
        }
    }
}
