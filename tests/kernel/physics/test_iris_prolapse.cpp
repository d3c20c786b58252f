// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "physics/anatomy/iris_prolapse.hpp"

using namespace rhexis;

namespace {

constexpr double dt = 0.01;
constexpr double width = 2.4;
constexpr double mmhg = pascal_per_mmhg;

ProlapseState after(double seconds, double pull, ProlapseState state = {}, double step = dt) {
    const ProlapseModel model;
    for (int i = 0; i < std::lround(seconds / step); ++i) {
        state.length = pushed_length(model, state, pull, width, step);
    }
    return state;
}

/// Where pressure, stiffness and friction balance on the way out (sign -1) and on the way back (+1).
double balance(double pull, double sign, double friction) {
    const ProlapseModel model;
    const double out = std::max(0.0, pull - model.holds) * model.patch * width;
    return std::clamp((out + sign * friction) / model.stiffness, 0.0, model.longest);
}

}  // namespace

TEST_SUITE("iris prolapse") {
    TEST_CASE("what the root bears draws nothing out") {
        CHECK(after(10.0, ProlapseModel{}.holds).length == 0.0);
        CHECK(after(10.0, 0.0).length == 0.0);
    }

    TEST_CASE("a pressure draws it out to where stiffness and friction balance it") {
        const ProlapseModel model;
        const double pull = 40.0 * mmhg;
        CHECK(after(20.0, pull).length == doctest::Approx(balance(pull, -1.0, model.friction)).epsilon(1e-6));
    }

    TEST_CASE("when the pressure falls friction holds it; a stroke sets it free") {
        const ProlapseModel model;
        ProlapseState state = after(20.0, 40.0 * mmhg);
        const double out = state.length;
        state = after(20.0, 22.0 * mmhg, state);
        CHECK(state.length == out);
        state.stroke_s = 1.0;
        state = after(20.0, 22.0 * mmhg, state);
        CHECK(state.length == doctest::Approx(balance(22.0 * mmhg, 1.0, model.stroked * model.friction)).epsilon(1e-6));
        state = after(20.0, 0.0, state);
        CHECK(state.length < 0.1);
    }

    TEST_CASE("a stroke alone does not bring it back against pressure") {
        ProlapseState state = after(20.0, 40.0 * mmhg);
        state.stroke_s = 1.0;
        CHECK(after(20.0, 40.0 * mmhg, state).length >= state.length);
    }

    TEST_CASE("a damaged iris comes out farther") {
        ProlapseState torn;
        torn.damage = 1.0;
        CHECK(after(20.0, 30.0 * mmhg, torn).length > 1.5 * after(20.0, 30.0 * mmhg).length);
    }

    TEST_CASE("any step stays within its length and gives the same end") {
        CHECK(after(20.0, 1e9).length == ProlapseModel{}.longest);
        CHECK(after(1e6, 40.0 * mmhg, {}, 1e6).length ==
              doctest::Approx(after(20.0, 40.0 * mmhg).length).epsilon(0.01));
        ProlapseState state;
        state.length = 6.0;
        CHECK(after(1e6, -1e9, state, 1e6).length >= 0.0);
    }

    TEST_CASE("iris in the wound stops most of its leak") {
        const ProlapseModel model;
        ProlapseState state;
        CHECK(unplugged_share(model, state) == 1.0);
        state.length = 3.0;
        CHECK(unplugged_share(model, state) == doctest::Approx(1.0 - model.plugs));
    }
}
