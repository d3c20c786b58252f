// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "flow/world.hpp"
#include "math/rotation.hpp"
#include "physics/fluid/chamber_flow.hpp"
#include "physics/fluid/fluid_step.hpp"
#include "tools/wound_tools.hpp"

using namespace rhexis;

namespace {

constexpr double dt = 0.01;
constexpr double usual = 20.0 * pascal_per_mmhg;

/// An eye whose balls are about the origin's axis, the front's apex at 4.9 mm.
WoundsModel cornea() {
    WoundsModel model;
    model.front_centre.z() = 4.9 - model.front_radius;
    model.back_centre.z() = 4.9 - 0.534 - model.back_radius;
    model.iris_z = 1.8;
    return model;
}

/// A world with one instrument.
struct Eye {
    WorldModel model;
    WorldState state;
    std::vector<ToolState> tools{1};
    std::vector<MouthProbe> probes{1};

    Eye(const ToolModel& tool, bool cut) {
        model.chamber = ChamberModel{};
        model.wounds = cornea();
        if (cut) {
            model.wounds->start[main_wound] = made_wound(*model.wounds, Vec2(0.0, -1.0), 2.0, 2.4, 1.8);
        }
        model.tools.push_back(tool);
        state = rest_state(model);
    }
    Wound& main() { return state.wounds->wounds[main_wound]; }

    void step(double jaw = 0.0) {
        tools[0].jaw = jaw;
        step_fluid(model, tools, probes, dt, state);
    }
    void put(const Vec3& place, const Vec3& shaft = Vec3(0.0, -0.9, 0.45)) {
        tools[0].previous_pose = tools[0].present ? tools[0].pose : Pose{place, Quat::Identity()};
        tools[0].pose = {place, turn_of_z(shaft)};
        tools[0].previous_pose.orientation = tools[0].pose.orientation;
        tools[0].present = true;
    }
    /// In pieces of a tenth of a millimetre.
    void go(const Vec3& place, double jaw = 0.0) {
        const Vec3 from = tools[0].pose.position;
        const int pieces = std::max(1, static_cast<int>(std::ceil((place - from).norm() / 0.1)));
        for (int i = 1; i <= pieces; ++i) {
            put(from + static_cast<double>(i) / pieces * (place - from));
            step(jaw);
        }
    }
    void wait(double seconds, double jaw = 0.0) {
        for (int i = 0; i < std::lround(seconds / dt); ++i) {
            tools[0].previous_pose = tools[0].pose;
            step(jaw);
        }
    }
    [[nodiscard]] double pressure() const { return eye_pressure(*model.chamber, state.chamber->eye_volume); }
};

double leak_at_20(const WoundsModel& model, double tunnel, double width) {
    return usual * wound_conductance(model, made_wound(model, Vec2(0.0, -1.0), tunnel, width, 1.8), 0.0, usual, 0.0);
}

}  // namespace

TEST_SUITE("wounds") {
    TEST_CASE("lips made from settings lie on the two sides of the cornea, as far apart as the tunnel is long") {
        const WoundsModel model = cornea();
        for (const double tunnel : {1.2, 2.0, 2.8}) {
            const Wound wound = made_wound(model, Vec2(0.6, -0.8), tunnel, 2.4, 1.8);
            CHECK(below_front(model, wound.outer) == doctest::Approx(0.0).epsilon(1e-9));
            CHECK(beyond_back(model, wound.inner) == doctest::Approx(0.0).epsilon(1e-9));
            CHECK(inset_of(model, wound.inner) == doctest::Approx(1.8));
            CHECK((wound.outer - wound.inner).norm() == doctest::Approx(tunnel).epsilon(1e-6));
        }
    }

    TEST_CASE("a straight way through the cornea gives its length, one plane, and its lips") {
        Eye eye(keratome(), false);
        const Vec3 from(0.0, -7.0, 2.2);
        const Vec3 to(0.0, -2.0, 2.2);
        eye.put(from);
        eye.step();
        eye.go(to);
        const Wound& wound = eye.main();
        REQUIRE(wound.cut);
        // where a line at that height meets the balls
        const double front = std::sqrt(7.63 * 7.63 - std::pow(2.2 - eye.model.wounds->front_centre.z(), 2.0));
        const double back = std::sqrt(6.45 * 6.45 - std::pow(2.2 - eye.model.wounds->back_centre.z(), 2.0));
        CHECK(wound.outer.y() == doctest::Approx(-front).epsilon(1e-3));
        CHECK(wound.inner.y() == doctest::Approx(-back).epsilon(1e-3));
        CHECK(wound.tunnel == doctest::Approx(front - back).epsilon(1e-3));
        CHECK(wound.planes == 1);
        CHECK(wound.width == doctest::Approx(2.4).epsilon(0.02));
    }

    TEST_CASE("a turn of more than 20 degrees is another plane; drawing back is none, and adds no length") {
        Eye eye(keratome(), false);
        eye.put(Vec3(0.0, -6.0, 2.1));
        eye.step();
        eye.go(Vec3(0.0, -4.8, 2.95));
        const double so_far = eye.main().tunnel;
        eye.go(Vec3(0.0, -5.4, 2.5));
        eye.go(Vec3(0.0, -4.8, 2.95));
        CHECK(eye.main().tunnel == doctest::Approx(so_far).epsilon(1e-9));
        CHECK(eye.main().planes == 1);
        eye.go(Vec3(0.0, -2.0, 2.9));
        CHECK(eye.main().cut);
        CHECK(eye.main().planes == 2);
    }

    TEST_CASE("the leak at 20 mmHg falls with the tunnel and rises with the width; a square wound is shut") {
        const WoundsModel model = cornea();
        CHECK(leak_at_20(model, 2.4, 2.4) == 0.0);
        CHECK(leak_at_20(model, 1.8, 2.4) == 0.0);
        double before = leak_at_20(model, 0.8, 2.4);
        CHECK(before > 5.0);
        for (const double tunnel : {1.0, 1.2, 1.4}) {
            const double now = leak_at_20(model, tunnel, 2.4);
            CHECK(now < before);
            before = now;
        }
        CHECK(leak_at_20(model, 1.4, 3.4) > before);
    }

    TEST_CASE("fully open it is a slit: P w h^3 / (12 mu L)") {
        const WoundsModel model = cornea();
        Wound wound = made_wound(model, Vec2(0.0, -1.0), 2.0, 2.4, 1.8);
        const double full = wound_conductance(model, wound, 10.0, usual, 0.0);
        CHECK(full == doctest::Approx(2.4 * std::pow(0.06, 3.0) / (12.0 * 0.72e-3 * 2.0)));
        wound.cut = false;
        CHECK(wound_conductance(model, wound, 10.0, usual, 0.0) == 0.0);
    }

    TEST_CASE("pressure shuts a tunnel, swelling and stitches more; a press opens it; a burn makes swelling useless") {
        const WoundsModel model = cornea();
        Wound wound = made_wound(model, Vec2(0.0, -1.0), 1.3, 2.4, 1.8);
        const double plain = gape_of(model, wound, 0.0, usual, 0.0);
        CHECK(gape_of(model, wound, 0.0, 2.0 * usual, 0.0) < plain);
        CHECK(gape_of(model, wound, 0.0, usual, 2.8e5) == doctest::Approx(plain + 0.35));
        wound.swelling = 1.0;
        CHECK(gape_of(model, wound, 0.0, usual, 0.0) == doctest::Approx(plain - 0.6));
        CHECK(gape_of(model, wound, 1.0, usual, 0.0) == doctest::Approx(plain + 1.0 - 0.6 * 0.3));
        wound.sutures = 2;
        CHECK(gape_of(model, wound, 1.0, usual, 0.0) == doctest::Approx(plain - 0.18));
    }

    TEST_CASE("volume is kept: what is injected, made and leaked") {
        Eye eye(hydration_cannula(), true);
        const double start = eye.state.chamber->eye_volume;
        eye.put(Vec3(0.0, -3.0, 2.9));
        eye.wait(1.0, 0.7);
        eye.wait(1.0);
        const WoundsState& wounds = *eye.state.wounds;
        CHECK(wounds.injected > 5.0);
        CHECK(eye.state.chamber->totals.leaked > 1.0);
        CHECK(eye.state.chamber->eye_volume ==
              doctest::Approx(start + wounds.injected + wounds.aqueous - eye.state.chamber->totals.leaked));
    }

    TEST_CASE("saline in the stroma swells it, up to 1; in the chamber it does not") {
        Eye eye(hydration_cannula(), true);
        const Vec3 stroma = 0.5 * (eye.main().outer + eye.main().inner);
        eye.put(stroma);
        eye.wait(1.0, 1.0);
        CHECK(eye.main().swelling == doctest::Approx(0.5).epsilon(0.01));
        CHECK(eye.state.wounds->injected == 0.0);
        eye.wait(5.0, 1.0);
        CHECK(eye.main().swelling <= 1.0);
        CHECK(eye.main().swelling > 0.99);
    }

    TEST_CASE("a stitch over the middle counts; one beside it, a shallow one, and one through the chamber do not") {
        Eye eye(needle_holder(), true);
        const auto pass = [&](double x, const Vec3& middle) {
            eye.put(Vec3(x, -6.7, 1.3));
            eye.step();
            eye.go(Vec3(x, middle.y(), middle.z()));
            eye.go(Vec3(x, -4.9, 3.4));
        };
        pass(1.2, Vec3(0.0, -5.7, 1.85));
        CHECK(eye.main().sutures == 0);
        pass(0.0, Vec3(0.0, -5.8, 2.15));
        CHECK(eye.main().sutures == 0);
        pass(0.0, Vec3(0.0, -4.6, 1.8));
        CHECK(eye.main().sutures == 0);
        pass(0.1, Vec3(0.0, -5.7, 1.85));
        CHECK(eye.main().sutures == 1);
        CHECK(eye.main().distortion > 0.3);
    }

    TEST_CASE("a sponge presses in proportion to how deep it is, and tests the wound after 0.3 s") {
        Eye eye(sponge(), true);
        const Vec3 in = (eye.model.wounds->front_centre - eye.main().outer).normalized();
        eye.put(eye.main().outer + 0.6 * in, -in);
        eye.wait(0.1);
        CHECK(eye.main().press == doctest::Approx(3.0e5 * 0.6).epsilon(1e-3));
        CHECK_FALSE(eye.state.wounds->checked);
        eye.wait(0.4);
        CHECK(eye.state.wounds->checked);
        CHECK(eye.state.wounds->tested_leak < 0.2);
    }

    TEST_CASE("a blunt tip beside the opening peels as far as it is pushed, through it nothing") {
        Eye eye(hydration_cannula(), true);
        eye.put(Vec3(0.0, -5.0, 2.6));
        eye.step();
        eye.go(Vec3(0.0, -2.5, 2.9));
        CHECK(eye.main().peel == 0.0);
        eye.go(Vec3(0.0, -4.6, 3.1));
        eye.go(Vec3(0.0, -2.8, 3.3));
        CHECK(eye.main().peel > 0.5);
        CHECK(eye.main().peel < 1.2);
    }

    TEST_CASE("bleeding behind a closed eye ends at its pressure; the chamber has none of that volume") {
        Eye eye(sponge(), true);
        eye.state.wounds->source = 30.0 * pascal_per_mmhg;
        const double front = volume_in_front(*eye.state.chamber, &*eye.state.wounds);
        eye.wait(30.0);
        CHECK(eye.pressure() / pascal_per_mmhg == doctest::Approx(45.0).epsilon(0.02));
        CHECK(eye.state.wounds->behind > 50.0);
        CHECK(volume_in_front(*eye.state.chamber, &*eye.state.wounds) == doctest::Approx(front).epsilon(0.05));
    }

    TEST_CASE("an eye that leaks gets soft, and one that is shut goes back to its pressure at rest") {
        Eye eye(sponge(), true);
        eye.main().tunnel = 0.9;
        eye.wait(20.0);
        CHECK(eye.pressure() < 6.0 * pascal_per_mmhg);
        Eye shut(sponge(), true);
        shut.state.chamber->eye_volume = eye_volume(*shut.model.chamber, 25.0 * pascal_per_mmhg);
        const double before = shut.pressure();
        shut.wait(10.0);
        CHECK(shut.pressure() < before);
        CHECK(shut.pressure() > 15.0 * pascal_per_mmhg);
    }

    TEST_CASE("numbers stay finite with degenerate wounds") {
        const WoundsModel model = cornea();
        Wound wound;
        wound.cut = true;
        for (const double pressure : {-1e5, 0.0, 1e7}) {
            CHECK(std::isfinite(wound_conductance(model, wound, 0.0, pressure, 0.0)));
        }
        const Wound short_one = made_wound(model, Vec2(0.0, -1.0), 0.0, 0.0, 5.8);
        CHECK(short_one.outer.allFinite());
        CHECK(std::isfinite(wound_conductance(model, short_one, 1.0, usual, 1e9)));
    }
}
