// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "eye/posterior_capsule.hpp"
#include "math/roots.hpp"
#include "physics/anatomy/capsule_wall.hpp"
#include "physics/physics.hpp"
#include "tools/phaco_tip.hpp"

using namespace rhexis;

namespace {

/// A bag without lens, an eye full of fluid, and a phaco tip whose axis is the eye's.
struct Rig {
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>();
    WorldState state;
    std::vector<ToolState> tools{ToolState{}};
    ContactSet contacts;
    Profile profile;
    std::optional<Physics> physics;

    Rig() {
        BagModel bag;
        bag.cushion = 1.5e5;
        bag.damping = 80.0;
        model->bags.push_back(bag);
        model->tools.push_back(phaco_tip());
        model->tools[0].bevel = 0.0;
        model->chamber = ChamberModel{};
        model->capsule = make_capsule(68.0);
        IrisModel iris;
        iris.rest_z = 2.0;
        model->iris = iris;
        state = rest_state(*model);
        Result<Physics> made = Physics::create(model, {});
        REQUIRE(made.ok());
        physics.emplace(std::move(made).value());
        tools[0].bottle_height = 750.0;
        tools[0].pump_flow = 25.0 * mm3_s_per_ml_min;
    }

    void step(const Vec3& tip, double aspiration, double power = 0.0) {
        ToolState& tool = tools[0];
        tool.previous_pose = tool.present ? tool.pose : Pose{tip, Quat::Identity()};
        tool.present = true;
        tool.pose.position = tip;
        tool.irrigation = true;
        tool.aspiration = aspiration;
        tool.power = power;
        WorldState next;
        const StepOutcome outcome = physics->advance(state, tools, 0.01, next, contacts, profile);
        REQUIRE(outcome.failure == StepFailure::none);
        state = next;
    }
    void hold(const Vec3& tip, double aspiration, int steps) {
        for (int i = 0; i < steps; ++i) {
            step(tip, aspiration);
        }
    }
    /// From where it is at 2 mm/s.
    void go(const Vec3& to, double aspiration, double power = 0.0) {
        const Vec3 from = tools[0].pose.position;
        const int steps = static_cast<int>(std::ceil((to - from).norm() / 0.02));
        for (int i = 1; i <= steps; ++i) {
            step(from + (to - from) * i / steps, aspiration, power);
        }
    }
    [[nodiscard]] double wall() const { return -model->bags[0].shape.posterior + state.bags[0].pose.position.z(); }
    void set_vacuum(double mmhg) { tools[0].vacuum_limit = mmhg * pascal_per_mmhg; }
};

}  // namespace

TEST_SUITE("posterior capsule") {
    TEST_CASE("cube roots") {
        for (const double x : {1e-12, 0.3, 1.0, 2.0, 27.0, 1e9}) {
            CHECK(cube_root(x) == doctest::Approx(std::cbrt(x)).epsilon(1e-14));
        }
        CHECK(cube_root(0.0) == 0.0);
        CHECK(cube_root(-1.0) == 0.0);
        CHECK(cube_root(std::nan("")) == 0.0);
    }

    TEST_CASE("a dimple's force and strain are those of a sheet, and of a point where the end is small") {
        const CapsuleModel capsule;
        const double stiff = capsule.membrane_stiffness;
        // The integrated sheet [YangFeng1970], of radius 1, by rhexis bench chart_posterior_capsule's equations
        const auto end = [&](double radius, double depth, double force, double strain) {
            CHECK(dimple_force(capsule, 2.0 * radius, 2.0 * depth) ==
                  doctest::Approx(2.0 * stiff * force * depth * depth * depth).epsilon(0.05));
            CHECK(dimple_strain(capsule, 2.0 * radius, 2.0 * depth) == doctest::Approx(strain).epsilon(0.09));
        };
        end(0.05, 0.1, 1.2987, 0.025394);
        end(0.05, 0.4, 1.2272, 0.30133);
        end(0.225, 0.4, 1.6782, 0.13235);
        end(0.225, 1.0, 1.0920, 0.94070);
        end(0.4, 0.5, 2.0924, 0.16350);
        // [Komaragiri2005]
        const double yielding = 1.0491 - 0.1462 * 0.47 - 0.15827 * 0.47 * 0.47;
        CHECK(dimple_force(capsule, 1e-6, 0.01) ==
              doctest::Approx(2.0 * stiff * std::pow(0.005 / yielding, 3)).epsilon(1e-3));
        CHECK(dimple_strain(capsule, 0.45, -1.0) == dimple_strain(capsule, 0.45, 1.0));
        CHECK(dimple_strain(capsule, 0.45, 0.0) == 0.0);
    }

    TEST_CASE("a sheet over a bore is strained as the integrated one, and beyond its range ever more") {
        const CapsuleModel capsule;
        const auto at = [&](double share) {  // p b / (E t)
            return bulge_strain(capsule, 0.35, share * capsule.membrane_stiffness / 0.35);
        };
        CHECK(at(0.01) == doctest::Approx(0.011445).epsilon(0.01));
        CHECK(at(0.2) == doctest::Approx(0.097431).epsilon(0.01));
        CHECK(at(1.0) == doctest::Approx(0.44664).epsilon(0.01));
        CHECK(at(2.0) > 1.0);
        CHECK(at(10.0) > at(5.0));
        CHECK(dimple_strain(capsule, 0.1, 3.0) > dimple_strain(capsule, 0.1, 2.0));
    }

    TEST_CASE("a blunt push dimples the capsule and lets it come back; a deeper one goes through") {
        Rig rig;
        rig.hold({0, 0, 1.0}, 0.0, 200);
        const double start = rig.wall();
        rig.go({0, 0, start - 0.8}, 0.0);
        CHECK(rig.state.capsule->depth == doctest::Approx(0.8).epsilon(0.05));
        CHECK(rig.state.capsule->force.z() < -100.0);
        CHECK(rig.state.capsule->hole_radius == 0.0);
        CHECK(rig.wall() < start);  // it takes the bag along a little
        rig.go({0, 0, 1.0}, 0.0);
        rig.hold({0, 0, 1.0}, 0.0, 100);
        CHECK(rig.state.capsule->depth == 0.0);
        CHECK(rig.wall() == doctest::Approx(start).epsilon(1e-3));
        CHECK(rig.state.capsule->hole_radius == 0.0);
        rig.go({0, 0, start - 2.5}, 0.0);
        CHECK(rig.state.capsule->hole_radius > 0.0);
        CHECK(rig.state.capsule->peak_strain > rig.model->capsule->ultimate_strain);
    }

    TEST_CASE("ultrasound goes through where a push does not") {
        Rig rig;
        rig.hold({0, 0, 1.0}, 0.0, 200);
        const double start = rig.wall();
        rig.go({0, 0, start - 0.8}, 0.0, 1.0);
        CHECK(rig.state.capsule->hole_radius > 0.0);
    }

    TEST_CASE("a hole lets lens and iris go back and deepens nothing by itself") {
        Rig rig;
        rig.hold({0, 0, 1.0}, 0.0, 300);
        const double before = rig.state.bags[0].cushion_z;
        const double volume = rig.state.chamber->eye_volume;
        rig.state.capsule->hole_radius = 1.0;
        rig.state.capsule->hole_place = {0, 0, -rig.model->bags[0].shape.posterior};
        rig.hold({0, 0, 1.0}, 0.0, 50);
        CHECK(rig.state.bags[0].cushion_z < before - 0.1);
        CHECK(rig.state.chamber->eye_volume == doctest::Approx(volume).epsilon(1e-3));
        CHECK(rig.state.capsule->hole_radius == 1.0);  // the eye is under pressure: nothing pulls at its edge
    }

    TEST_CASE("a hole grows while the chamber is collapsed, and not else") {
        const CapsuleModel capsule;
        CHECK(hole_energy(capsule, 8.0, 1.0, 2000.0) > capsule.tear_energy);
        CHECK(hole_energy(capsule, 8.0, 1.0, 200.0) < capsule.tear_energy);
        Rig rig;
        rig.hold({0, 0, 1.0}, 0.0, 100);
        rig.state.capsule->hole_radius = 1.0;
        rig.state.capsule->hole_place = {0, 0, -rig.model->bags[0].shape.posterior};
        rig.tools[0].bottle_height = 0.0;
        rig.set_vacuum(200.0);
        rig.hold({0, 0, 1.0}, 1.0, 200);
        CHECK(rig.state.flows.lowest_eye_pressure < 5.0 * pascal_per_mmhg);
        CHECK(rig.state.capsule->hole_radius > 1.2);
    }

    TEST_CASE("suction near the capsule catches it; letting go in time saves it, more vacuum or pulling away do not") {
        const auto caught = [](double vacuum) {
            Rig rig;
            rig.set_vacuum(vacuum);
            rig.hold({0, 0, 1.0}, 1.0, 200);
            rig.go({0, 0, rig.wall() + 0.05}, 1.0);
            rig.hold(rig.tools[0].pose.position, 1.0, 60);
            return rig;
        };
        Rig free;
        free.hold({0, 0, 1.0}, 0.0, 200);
        free.go({0, 0, free.wall() + 0.05}, 0.0);
        free.hold(free.tools[0].pose.position, 0.0, 60);
        CHECK_FALSE(free.state.capsule->captured);  // covered, but nothing sucks
        CHECK(free.state.tips[0].capsule > 0.9);
        Rig saved = caught(100.0);
        REQUIRE(saved.state.capsule->captured);
        CHECK(saved.state.tips[0].open == 0.0);
        CHECK(saved.state.capsule->strain > 0.1);
        saved.hold(saved.tools[0].pose.position, 0.0, 100);
        CHECK_FALSE(saved.state.capsule->captured);
        CHECK(saved.state.capsule->hole_radius == 0.0);
        Rig pulled = caught(100.0);
        pulled.go({0, 0, pulled.wall() + 3.0}, 1.0);
        CHECK(pulled.state.capsule->hole_radius > 0.0);
        CHECK(caught(150.0).state.capsule->hole_radius > 0.0);
        const Rig burst = caught(600.0);
        CHECK(burst.state.capsule->hole_radius > 0.0);
    }

    TEST_CASE("a captured capsule holds the bag and the tip together") {
        Rig rig;
        rig.set_vacuum(80.0);
        rig.hold({0, 0, 1.0}, 1.0, 200);
        rig.go({0, 0, rig.wall() + 0.05}, 1.0);
        rig.hold(rig.tools[0].pose.position, 1.0, 60);
        REQUIRE(rig.state.capsule->captured);
        const double before = rig.wall();
        rig.go(rig.tools[0].pose.position + Vec3(0, 0, 0.4), 1.0);
        REQUIRE(rig.state.capsule->captured);
        CHECK(rig.state.capsule->force.z() > 100.0);
        CHECK(rig.wall() > before);
    }

    TEST_CASE("iris in the mouth is caught, stretched, and slips off or is let go") {
        Rig rig;
        rig.set_vacuum(150.0);
        rig.hold({0, 0, 3.0}, 1.0, 200);
        CHECK(rig.state.iris->tool == -1);
        const double edge = rig.state.iris->pupil_radius;
        const double plane = rig.state.iris->z;
        // The mouth in the plane of the iris, over its edge
        rig.go({edge + 0.3, 0, plane}, 1.0);
        rig.hold(rig.tools[0].pose.position, 1.0, 20);
        REQUIRE(rig.state.iris->tool == 0);
        rig.hold(rig.tools[0].pose.position, 1.0, 100);
        CHECK(rig.state.tips[0].open == 0.0);
        rig.go({edge - 0.5, 0, plane + 0.3}, 1.0);
        REQUIRE(rig.state.iris->tool == 0);
        CHECK(rig.state.iris->strain > 0.1);
        rig.hold(rig.tools[0].pose.position, 0.0, 100);
        CHECK(rig.state.iris->tool == -1);
        CHECK(rig.state.iris->strain == 0.0);
        CHECK(rig.state.iris->torn == 0.0);
    }

    TEST_CASE("iris torn by a strong hold and a long pull") {
        Rig rig;
        rig.set_vacuum(600.0);
        rig.hold({0, 0, 3.0}, 1.0, 200);
        rig.go({rig.state.iris->pupil_radius + 0.3, 0, rig.state.iris->z}, 1.0);
        rig.hold(rig.tools[0].pose.position, 1.0, 100);
        REQUIRE(rig.state.iris->tool == 0);
        rig.go({1.5, 0, rig.state.iris->z + 0.5}, 1.0);
        CHECK(rig.state.iris->torn > 0.0);
    }

    TEST_CASE("the pupil widens and goes back under irrigation, narrows when the chamber empties") {
        Rig rig;
        const double rest = rig.model->iris->pupil_radius;
        rig.hold({0, 0, 3.0}, 0.0, 300);
        CHECK(rig.state.iris->pupil_radius > 1.02 * rest);
        CHECK(rig.state.iris->z < rig.model->iris->rest_z - 0.3);
        rig.tools[0].bottle_height = 0.0;
        rig.set_vacuum(200.0);
        rig.hold({0, 0, 3.0}, 1.0, 300);
        CHECK(rig.state.iris->pupil_radius < 0.98 * rest);
        CHECK(rig.state.iris->z > rig.model->iris->rest_z + 0.3);
    }
}
