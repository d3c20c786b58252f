// SPDX-License-Identifier: GPL-3.0-or-later
// How far the plunger of an injector goes: where the hand wants it, or where it takes all the force of a hand.
#include <doctest/doctest.h>

#include <algorithm>

#include "physics/shell/plunger.hpp"
#include "scenes/injection.hpp"
#include "scenes/shell_contacts.hpp"

using namespace rhexis;

namespace {

/// A bore of 2 mm that narrows on a millimetre to a nozzle of 2 mm length.
ToolModel small_injector(double nozzle_radius) {
    ToolModel tool;
    tool.name = "injector";
    tool.kind = ToolKind::injector;
    tool.friction = 0.2;
    Cartridge& cartridge = tool.cartridge.emplace();
    cartridge.bore.pose.orientation = Quat(0.0, 1.0, 0.0, 0.0);  // half a turn about x
    cartridge.bore.stations = {
        {-3.0, 1.0, 1.0}, {-2.0, nozzle_radius, nozzle_radius}, {0.0, nozzle_radius, nozzle_radius}};
    cartridge.plunger_radius = 0.3;
    cartridge.plunger_from = -5.7;
    cartridge.stroke = 5.9;
    cartridge.most_force = 1e4;
    cartridge.fastest = 40.0;
    return tool;
}

/// A strip that lies in the wide bore.
ShellModel strip() {
    ShellModel model = scenes::flat_strip(2.0, 1.6, 0.2, 8, 8);
    for (Vec3& node : model.mesh.nodes) {
        node = Vec3(0.8 - node.y(), 0.0, 5.4 - node.x());  // z points back to the hand
    }
    model.drag = 0.02;
    return model;
}

constexpr double dt = 0.01;
constexpr int pushing = 120;  // steps

}  // namespace

TEST_SUITE("plunger") {
    TEST_CASE("it goes where the hand wants it, as fast as a hand is, and gives way where that takes too much") {
        Cartridge cartridge;
        cartridge.most_force = 100.0;
        cartridge.fastest = 10.0;
        CHECK(plunger_goal(cartridge, {1.0, 0.0, 0.0}, 1.05, 0.01) == doctest::Approx(1.05));
        CHECK(plunger_goal(cartridge, {1.0, 0.0, 0.0}, 3.0, 0.01) == doctest::Approx(1.1));
        CHECK(plunger_goal(cartridge, {1.0, 50.0, 1000.0}, 3.0, 0.01) == doctest::Approx(1.05));
        CHECK(plunger_goal(cartridge, {1.0, 120.0, 1000.0}, 3.0, 0.01) == doctest::Approx(0.98));
        CHECK(plunger_goal(cartridge, {1.0, 120.0, 1000.0}, 0.5, 0.01) == doctest::Approx(0.9));
        CHECK_FALSE(nearer_goal(cartridge, {1.0, 50.0, 0.0}, 1.05, 100.0));
        CHECK(*nearer_goal(cartridge, {1.0, 50.0, 0.0}, 1.05, 150.0) == doctest::Approx(1.025));
        CHECK(*nearer_goal(cartridge, {1.0, 100.0, 0.0}, 1.05, 150.0) == 1.0);
        CHECK(*nearer_goal(cartridge, {1.0, 50.0, 0.0}, 1.05, HUGE_VAL) == 1.0);
        CHECK_FALSE(nearer_goal(cartridge, {1.0, 150.0, 0.0}, 0.99, 140.0));
        CHECK(pushed_plunger({1.0, 50.0, 0.0}, 1.05, 100.0, false).stiffness == doctest::Approx(1000.0));
        CHECK(pushed_plunger({1.0, 50.0, 1000.0}, 1.05, 40.0, true).stiffness == doctest::Approx(800.0));
        CHECK(pushed_plunger({1.0, 50.0, 1000.0}, 1.0, 40.0, true).stiffness == 1000.0);
        CHECK(pushed_plunger({1.0, 50.0, 1000.0}, 1.0, 40.0, true, 5000.0).stiffness == 5000.0);
    }

    TEST_CASE(
        "through a wide nozzle it pushes a strip out; in a narrow one it stops, presses as it may and goes back") {
        const ShellModel model = strip();
        for (const bool wide : {true, false}) {
            const ToolModel tool = small_injector(wide ? 1.0 : 0.4);
            const double most = tool.cartridge->most_force;
            scenes::Injection injection(model, tool, rest_state(model));
            double strongest = 0.0;
            double deepest = 0.0;
            for (int i = 1; i <= pushing; ++i) {
                CHECK(injection.step(static_cast<double>(i) / pushing, dt) == ShellMotion::balanced);
                strongest = std::max(strongest, injection.plunger.force);
                deepest = std::max(deepest, injection.contacts.deepest());
            }
            CHECK(deepest < 0.1);
            const double stopped = injection.plunger.pushed;
            if (wide) {
                CHECK(stopped == doctest::Approx(tool.cartridge->stroke));
                CHECK(strongest < 0.1 * most);
                continue;
            }
            CHECK(stopped < 0.9 * tool.cartridge->stroke);
            CHECK(strongest <= 1.02 * most);
            double least = HUGE_VAL;
            for (int i = 0; i < 30; ++i) {
                injection.step(1.0, dt);
                least = std::min(least, injection.plunger.force);
                strongest = std::max(strongest, injection.plunger.force);
            }
            CHECK(strongest <= 1.02 * most);
            CHECK(least > 0.9 * most);
            CHECK(injection.plunger.pushed == doctest::Approx(stopped).epsilon(0.01));
            for (int i = 0; i < 10; ++i) {
                injection.step(0.1, dt);
            }
            CHECK(injection.plunger.force == 0.0);
            CHECK(injection.plunger.pushed < 0.9 * stopped);
        }
    }
}
