// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions of a capsulorhexis: what is built for one, and what is refused.
#include <doctest/doctest.h>

#include <limits>

#include "kernel/session/sessions.hpp"
#include "support/sample.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

SceneDescription capsule_scene() {
    SceneDescription scene;
    scene.tissues = {"anterior_capsule", "viscoelastic", "iris", "cornea"};
    scene.instruments = {"cystotome", "forceps"};
    scene.settings = {{"capsule.triangles", 300.0}};
    return scene;
}

std::string refusal_of(const std::string& setting, double value) {
    SceneDescription scene = capsule_scene();
    scene.settings[setting] = value;
    return refusal(scene);
}

}  // namespace

TEST_SUITE("capsule session") {
    TEST_CASE("one membrane is built, and nothing else") {
        const Session session = make_session(capsule_scene());
        const WorldModel& world = session.world();
        CHECK(world.membranes.size() == 1);
        CHECK(world.membranes[0].name == anterior_capsule_name);
        CHECK(world.viscoelastic.has_value());
        CHECK(world.solids.empty());
        CHECK(world.bags.empty());
        CHECK_FALSE(world.chamber.has_value());
        CHECK_FALSE(world.capsule.has_value());
        CHECK_FALSE(world.iris.has_value());  // it stands still: only fluid that flows moves it
        CHECK(world.domes.empty());
        CHECK(world.planes.empty());
        CHECK(session.eye().lens.coarse.nodes.empty());
        CHECK(session.eye().lens.coarse.tets.empty());
        CHECK(session.eye().lens.fine.tets.empty());
        CHECK(session.frame().eye->has_iris);
        CHECK(session.frame().eye->has_cornea);
        const WorldState& state = session.state();
        CHECK(state.membranes.size() == 1);
        CHECK(state.solids.empty());
        CHECK(state.bags.empty());
        CHECK_FALSE(state.chamber.has_value());
        CHECK_FALSE(state.capsule.has_value());
        CHECK_FALSE(state.iris.has_value());
        CHECK(state.debris.empty());
    }

    TEST_CASE("a lens or a bag that takes part has its tetrahedra") {
        for (const char* tissue : {"lens", "bag"}) {
            SceneDescription scene;
            scene.patient.tetrahedra = 500;
            scene.tissues = {tissue};
            CHECK_FALSE(make_session(scene).eye().lens.coarse.tets.empty());
        }
    }

    TEST_CASE("settings out of their range are named with value and range") {
        CHECK(refusal_of("capsule.triangles", 100.0) == "settings.capsule.triangles is 100 (200 to 20000)");
        CHECK(refusal_of("capsule.triangles", 1e6) == "settings.capsule.triangles is 1000000 (200 to 20000)");
        CHECK(refusal_of("capsule.toughness", 0.0) == "settings.capsule.toughness is 0 (0.2 to 5)");
        CHECK(refusal_of("capsule.fibres", -1.0) == "settings.capsule.fibres is -1 (0 to 1)");
        CHECK(refusal_of("capsule.strength", 3.0) == "settings.capsule.strength is 3 (0.1 to 2)");
        CHECK(refusal_of("capsule.trypan_blue", 2.0) == "settings.capsule.trypan_blue is 2 (0 to 1)");
        CHECK(refusal_of("viscoelastic.fill", 1.5) == "settings.viscoelastic.fill is 1.5 (0 to 1.2)");
        CHECK(refusal_of("vitreous.pressure_mmhg", 80.0) == "settings.vitreous.pressure_mmhg is 80 (0 to 25)");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const char* setting :
             {"capsule.triangles", "capsule.toughness", "viscoelastic.fill", "vitreous.pressure_mmhg"}) {
            CHECK(refusal_of(setting, nan).find(std::string("settings.") + setting + " is nan (") == 0);
        }
        CHECK(refusal_of("capsule.thoughness", 1.0).find("did you mean capsule.toughness") != std::string::npos);
        CHECK(refusal_of("viscoelastic.fil", 1.0).find("did you mean viscoelastic.fill") != std::string::npos);
    }

    TEST_CASE("tissues that exclude each other are refused") {
        for (const char* other : {"lens", "bag", "chamber"}) {
            SceneDescription scene = capsule_scene();
            scene.tissues.emplace_back(other);
            CHECK(refusal(scene).find(std::string("with ") + other) != std::string::npos);
        }
    }

    TEST_CASE("a broken number from a device leaves instrument and capsule as without it") {
        Session session = make_session(capsule_scene());
        Session calm = make_session(capsule_scene());
        const DeviceSample good = sample_at(0, Vec3(0.5, 0.5, 2.2));
        session.step({&good, 1}, {});
        calm.step({&good, 1}, {});
        for (const int field : {0, 1, 2, 3}) {
            DeviceSample broken = sample_at(0, Vec3(0.5, 0.5, 1.2));
            const double nan = std::numeric_limits<double>::quiet_NaN();
            (field == 0   ? broken.pose.position.z()
             : field == 1 ? broken.pose.orientation.x()
             : field == 2 ? broken.jaw
                          : broken.pedal) = nan;
            session.step({&broken, 1}, {});
            calm.step({}, {});
            CHECK(session.tools()[0].pose.position == good.pose.position);
            CHECK(session.state().membranes[0].position == calm.state().membranes[0].position);
        }
        REQUIRE(session.log().size() == 1);
        CHECK(session.log()[0].text.find("pose.position.z is nan (-200 to 200)") != std::string::npos);
    }
}
