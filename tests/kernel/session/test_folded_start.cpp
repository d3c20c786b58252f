// SPDX-License-Identifier: GPL-3.0-or-later
// A folded implant begins scenes that have more in them than the one in which it was folded.
#include "session/folded_start.hpp"

#include "kernel/session/sessions.hpp"
#include "session/implant_fold.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

const std::map<std::string, double> coarse{{"implant.triangles", 400.0}};

/// As if folded: an implant that lies in its injector, moved from where it rests.
PreparedState folded() {
    const Session session = make_session(folding_scene(coarse));
    Snapshot snapshot = session.copy_state();
    ShellState& implant = snapshot.world.shells[0];
    Pose by;
    by.position = Vec3(0.0, 0.0, 15.0);
    implant = moved(std::move(implant), by);
    implant.loaded = true;
    implant.touches = {{ContactPartner::tool, 0, 3, true, Vec3::Zero()},
                       {ContactPartner::tube, 0, 5, true, Vec3(0.0, 0.01, 0.0)}};
    return {header_of(session), std::move(snapshot)};
}

SceneDescription eye_scene() {
    SceneDescription scene;
    scene.patient.age = 74.0;
    scene.tissues = {"implant", "iris", "cornea", "viscoelastic"};
    scene.instruments = {"spatula", "injector", "microscope"};
    scene.step_s = 0.02;
    scene.settings = coarse;
    scene.settings["viscoelastic.fill"] = 0.8;
    return scene;
}

/// Why the scene does not begin with the state; "" where it does. A session that is refused stays as it was.
std::string refusal(const SceneDescription& scene, const PreparedState& state) {
    Session session = make_session(scene);
    const std::uint64_t before = session.state_hash();
    const Status status = start_from(session, state);
    CHECK(status.ok() == (session.state_hash() != before));
    return status ? "" : status.error().text();
}

bool holds(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("folded start") {
    TEST_CASE("an eye with other tissues and instruments begins with the implant in its injector, else as it was") {
        const PreparedState state = folded();
        Session session = make_session(eye_scene());
        const Snapshot before = session.copy_state();
        REQUIRE(start_from(session, state).ok());
        const Snapshot after = session.copy_state();
        const ShellState& implant = after.world.shells[0];
        CHECK(implant.loaded);
        CHECK(implant.position == state.snapshot.world.shells[0].position);
        CHECK(implant.branch == state.snapshot.world.shells[0].branch);
        CHECK(after.settings == before.settings);
        CHECK(after.tools.size() == 2);
        CHECK(after.world.viscoelastic->fill == before.world.viscoelastic->fill);
        CHECK(after.world.microscope->position == before.world.microscope->position);
        CHECK(after.step == 0);
        REQUIRE(implant.touches.size() == 1);  // the tool of that number is another one here
        CHECK(implant.touches[0].partner == ContactPartner::tube);
    }

    TEST_CASE("it comes into the eye with the injector, whatever the injector's number") {
        Session session = make_session(eye_scene());
        REQUIRE(start_from(session, folded()).ok());
        DeviceSample spatula;
        spatula.present = true;
        spatula.pose.position = Vec3(-30.0, 0.0, 0.0);
        session.step({&spatula, 1}, {});
        CHECK(session.state().shells[0].loaded);
        DeviceSample injector;
        injector.instrument = 1;
        injector.present = true;
        injector.pose.position = Vec3(0.0, -20.0, 0.0);
        session.step({&injector, 1}, {});
        CHECK_FALSE(session.state().shells[0].loaded);
    }

    TEST_CASE("what was folded with other settings is refused, and they are named") {
        SceneDescription scene = eye_scene();
        scene.settings["implant.haptic_mm"] = 0.3;
        scene.settings["cartridge.nozzle_mm"] = 2.4;
        scene.settings["zonules.strength"] = 0.5;  // has nothing to do with it
        CHECK(refusal(scene, folded()) ==
              "the implant was folded with other settings: cartridge.nozzle_mm 2.8 there, "
              "2.4 here; implant.haptic_mm 0.4 there, 0.3 here");
    }

    TEST_CASE("a scene without implant or injector is refused") {
        SceneDescription scene = eye_scene();
        scene.instruments = {"spatula"};
        CHECK(holds(refusal(scene, folded()), "names no instrument injector (a scene with the tissue implant"));
        scene = eye_scene();
        scene.tissues = {"iris", "cornea"};
        CHECK(holds(refusal(scene, folded()), "names no tissue implant"));
        scene.tissues = {};
        scene.instruments = {};
        CHECK(holds(refusal(scene, folded()), "names no tissue implant"));
    }

    TEST_CASE("a lens of another mesh with the same settings is refused") {
        PreparedState state = folded();
        ShellState& implant = state.snapshot.world.shells[0];
        implant.position.pop_back();
        CHECK_FALSE(refusal(eye_scene(), state).empty());
        state = folded();
        state.snapshot.world.shells[0].branch.resize(15);
        CHECK_FALSE(refusal(eye_scene(), state).empty());
    }

    TEST_CASE("an implant that lies in no injector begins its own scene only") {
        PreparedState state = folded();
        state.snapshot.world.shells[0].loaded = false;
        CHECK(holds(refusal(eye_scene(), state), "tissues implant there, implant + iris + cornea + viscoelastic here"));
        CHECK(refusal(folding_scene(coarse), state).empty());
        state = folded();
        state.snapshot.world.shells.clear();
        CHECK(holds(refusal(eye_scene(), state), "instruments injector there"));
    }
}
