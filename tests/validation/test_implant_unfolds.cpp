// SPDX-License-Identifier: GPL-3.0-or-later
// The foldable lens let go: its material says how long it takes to unfold, not the step.
#include <doctest/doctest.h>

#include <cmath>

#include "physics/shell/shell_stepper.hpp"
#include "scenes/shells.hpp"

using namespace rhexis;

namespace {

/// Until a tenth of the fold is left [s]; what is longer than `longest` is infinite.
double unfolding_time(const scenes::FoldedOptic& optic, const ShellState& folded, double dt, double longest) {
    const ShellModel& model = optic.implant.model;
    ShellStepper stepper = std::move(ShellStepper::create(model)).value();
    ShellState state = folded;
    state.branch = rest_state(model).branch;
    const double goal = 0.1 * scenes::fold_degrees(optic, folded);
    double angle = scenes::fold_degrees(optic, folded);
    for (double time = 0.0; time < longest; time += dt) {
        const ImplicitReport report = stepper.step(
            state, {}, Vec3::Zero(), dt,
            {.tolerance = 1e-3, .max_newton = 60, .newton_tolerance = 1e-5, .predict_stress = true}, state);
        CHECK(report.converged);
        const double now = scenes::fold_degrees(optic, state);
        if (now <= goal) {
            return time + dt * (angle - goal) / (angle - now);
        }
        angle = now;
    }
    return INFINITY;
}

}  // namespace

TEST_SUITE("implant unfolds") {
    TEST_CASE("viscous, in the same time whatever the step; elastic, in a time that is the step's") {
        scenes::FoldedOptic optic = scenes::folded_optic(400);
        const ShellState folded = scenes::folded_state(optic, 4e4);
        REQUIRE(scenes::fold_degrees(optic, folded) > 90.0);
        ShellModel& model = optic.implant.model;
        model.temperature = 37.0;
        model.drag = disc_drag(1e-3, 3.0);
        const double elastic = unfolding_time(optic, folded, 0.02, 10.0);
        CHECK(unfolding_time(optic, folded, 0.005, 10.0) < 0.7 * elastic);
        model.relaxation = ShellRelaxation{};
        const double viscous = unfolding_time(optic, folded, 0.02, 10.0);
        CHECK(unfolding_time(optic, folded, 0.005, 10.0) == doctest::Approx(viscous).epsilon(0.05));
        // free of load it would be (1 + share) time ln(10 share / (1 + share)); inertia is next to nothing
        const double time = relaxation_time(*model.relaxation, model.temperature);
        CHECK(viscous == doctest::Approx(10.0 * time * std::log(9.0)).epsilon(0.1));
    }

    TEST_CASE("at 23 C it takes 5 to 20 s, less when warmer") {
        scenes::FoldedOptic optic = scenes::folded_optic(400);
        const ShellState folded = scenes::folded_state(optic, 4e4);
        ShellModel& model = optic.implant.model;
        model.relaxation = ShellRelaxation{};
        model.drag = disc_drag(1e-3, 3.0);
        const double cool = unfolding_time(optic, folded, 0.04, 30.0);
        CHECK(cool > 5.0);
        CHECK(cool < 20.0);
        model.temperature = 37.0;
        CHECK(unfolding_time(optic, folded, 0.04, 30.0) < 0.3 * cool);
    }
}
