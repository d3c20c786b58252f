// SPDX-License-Identifier: GPL-3.0-or-later
// A viscoelastic shell against closed forms, its energy, and the drag of a fluid.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/index.hpp"
#include "physics/shell/shell_energy.hpp"
#include "physics/shell/shell_statics.hpp"
#include "physics/shell/shell_stepper.hpp"
#include "scenes/shell_problems.hpp"

using namespace rhexis;

namespace {

const ImplicitSettings balanced{.tolerance = 1e-6, .max_newton = 30, .newton_tolerance = 1e-8};
constexpr double share = 4.0;
constexpr double tau = 0.2;

/// 10 by 1, thickness 0.1, its left end held; it does not narrow when stretched, so that strains are uniform.
ShellModel strip() {
    const auto map = [](double s, double t) { return Vec3(10.0 * s, t, 0.0); };
    ShellModel model = uniform_shell("strip", scenes::grid_mesh(16, 2, scenes::GridCut::alternate, map), 0.1);
    model.material.poisson_ratio = 0.0;
    model.relaxation = ShellRelaxation{.branch_share = share, .time = tau};
    return model;
}

void hold_at(double x, ShellModel& model) {
    for (int n = 0; n < static_cast<int>(model.mesh.nodes.size()); ++n) {
        if (std::abs(model.mesh.nodes[at(n)].x() - x) < 1e-9) {
            model.holds.push_back({n, {true, true, true, true, true, true}});
        }
    }
    std::sort(model.holds.begin(), model.holds.end(),
              [](const ShellHold& a, const ShellHold& b) { return a.node < b.node; });
}

/// Force and moment of all holds at the left end.
Vec6 at_left(const ShellModel& model, const std::vector<Vec6>& forces) {
    Vec6 sum = Vec6::Zero();
    for (std::size_t i = 0; i < forces.size(); ++i) {
        if (model.mesh.nodes[at(model.holds[i].node)].x() < 1e-9) {
            sum += forces[i];
        }
    }
    return sum;
}

/// The strip rolled up by an end moment to an arc of this angle, at equilibrium of the long-term modulus.
ShellState rolled(const ShellModel& model, double angle) {
    ShellLoad load;
    load.moment.assign(model.mesh.nodes.size(), Vec3::Zero());
    const double bending = model.material.young_modulus * 1e-3 / 12.0;  // width 1, thickness 0.1
    for (std::size_t n = 0; n < load.moment.size(); ++n) {
        if (model.mesh.nodes[n].x() > 10.0 - 1e-9) {
            const double part = std::abs(model.mesh.nodes[n].y() - 0.5) < 1e-9 ? 0.5 : 0.25;
            load.moment[n].y() = -part * bending * angle / 10.0;
        }
    }
    ShellStatics statics = std::move(ShellStatics::create(model)).value();
    ShellState state = rest_state(model);
    REQUIRE(statics.load_to(load, 0.0, 1.0, {.tolerance = 1e-9, .max_iterations = 60}, state).converged);
    return state;
}

}  // namespace

TEST_SUITE("shell relaxation") {
    TEST_CASE("a stretched strip's force dies away to its share as the closed form says, at any step") {
        ShellModel model = strip();
        hold_at(0.0, model);
        hold_at(10.0, model);
        const double strain = 0.01;
        const double lasting = strain * model.material.young_modulus * 0.1;  // width 1
        for (const double dt : {0.002, 0.02, 0.2}) {
            ShellState state = rest_state(model);
            for (Vec3& x : state.position) {
                x.x() *= 1.0 + strain;
            }
            state.branch = ShellLedger(model).deformation(state);
            ShellStepper stepper = std::move(ShellStepper::create(model)).value();
            for (double t = dt; t < 0.81; t += dt) {
                stepper.step(state, {}, Vec3::Zero(), dt, balanced, state);
                const double force = at_left(model, stepper.hold_forces()).x();
                CHECK(force == doctest::Approx(lasting * (1.0 + share * std::exp(-t / tau))).epsilon(1e-6));
            }
        }
    }

    TEST_CASE("so does the moment of a strip bent to a half circle") {
        ShellModel model = strip();
        hold_at(0.0, model);
        ShellState state = rolled(model, 3.0);
        hold_at(10.0, model);
        state.branch = ShellLedger(model).deformation(state);
        ShellStepper stepper = std::move(ShellStepper::create(model)).value();
        const double lasting = model.material.young_modulus * 1e-3 / 12.0 * 3.0 / 10.0;
        for (int i = 1; i <= 40; ++i) {
            stepper.step(state, {}, Vec3::Zero(), 0.02, balanced, state);
            const double moment = std::abs(at_left(model, stepper.hold_forces())[4]);
            CHECK(moment == doctest::Approx(lasting * (1.0 + share * std::exp(-i * 0.02 / tau))).epsilon(0.01));
        }
    }

    TEST_CASE("a strip under a constant pull creeps as the closed form says") {
        ShellModel model = strip();
        hold_at(0.0, model);
        ShellLoad load;
        load.force.assign(model.mesh.nodes.size(), Vec3::Zero());
        std::size_t end = 0;
        for (std::size_t n = 0; n < load.force.size(); ++n) {
            if (model.mesh.nodes[n].x() > 10.0 - 1e-9) {
                const bool middle = std::abs(model.mesh.nodes[n].y() - 0.5) < 1e-9;
                load.force[n].x() = middle ? 500.0 : 250.0;
                end = middle ? n : end;
            }
        }
        const double lasting = 10.0 * 1000.0 / (model.material.young_modulus * 0.1);  // 0.1 mm
        ShellStepper stepper = std::move(ShellStepper::create(model)).value();
        ShellState state = rest_state(model);
        const double dt = 0.005;
        for (int i = 1; i <= 600; ++i) {
            stepper.step(state, load, Vec3::Zero(), dt, balanced, state);
            if (i >= 10 && i % 10 == 0) {
                const double left = share / (1.0 + share) * std::exp(-i * dt / ((1.0 + share) * tau));
                CHECK(state.position[end].x() - 10.0 == doctest::Approx(lasting * (1.0 - left)).epsilon(0.01));
            }
        }
    }

    TEST_CASE("let go, it gains no energy: what is stored goes to the dashpot, the fluid and backward Euler") {
        ShellModel model = strip();
        hold_at(0.0, model);
        model.drag = 0.02;
        const ShellState bent = rolled(model, 2.0);
        for (const double dt : {0.001, 0.01, 0.1}) {
            for (const bool at_once : {false, true}) {
                ShellState state = bent;
                const ShellLedger ledger(model);
                if (at_once) {
                    state.branch = ledger.deformation(state);
                }
                ShellStepper stepper = std::move(ShellStepper::create(model)).value();
                const double start = ledger.energy(state).all();
                double taken = 0.0;
                double left = 0.0;  // of steps that did not balance
                for (int i = 0; i < 60; ++i) {
                    const ShellState before = state;
                    const ImplicitReport report = stepper.step(before, {}, Vec3::Zero(), dt, balanced, state);
                    const ShellStepEnergy e = ledger.step(before, state, {}, Vec3::Zero(), dt);
                    CHECK(e.external == 0.0);
                    CHECK(e.viscosity >= 0.0);
                    CHECK(e.drag >= 0.0);
                    CHECK(e.gain <= 1e-9 * start);
                    CHECK(e.integrator >= -1e-9 * start);
                    taken += e.viscosity + e.drag + e.integrator;
                    CHECK((!report.converged || std::abs(e.rest) < 1e-7 * start));
                    left += e.rest;
                }
                CHECK(taken > 0.1 * start);
                CHECK(ledger.energy(state).all() + taken + left == doctest::Approx(start).epsilon(1e-9));
            }
        }
    }

    TEST_CASE("the dashpot takes what the power of its stress adds up to") {
        ShellModel model = strip();
        hold_at(0.0, model);
        hold_at(10.0, model);
        ShellState state = rest_state(model);
        for (Vec3& x : state.position) {
            x.x() *= 1.01;
        }
        const ShellLedger ledger(model);
        state.branch = ledger.deformation(state);
        const double branch = ledger.energy(state).branch;
        ShellStepper stepper = std::move(ShellStepper::create(model)).value();
        ShellState after;
        stepper.step(state, {}, Vec3::Zero(), 0.15, balanced, after);
        const double lost = branch * (1.0 - std::exp(-2.0 * 0.15 / tau));  // power: twice the energy over tau
        CHECK(ledger.step(state, after, {}, Vec3::Zero(), 0.15).viscosity == doctest::Approx(lost).epsilon(1e-6));
    }

    TEST_CASE("every instruction set gives the same bits, and the step before leaves nothing behind") {
        ShellModel model = strip();
        hold_at(0.0, model);
        ShellState start = rest_state(model);
        for (Vec3& x : start.position) {
            x.z() = 0.02 * x.x() * x.x();
        }
        ShellState reference;
        for (const char* set : {"baseline", "avx2", "avx512"}) {
            Result<ShellStepper> stepper = ShellStepper::create(model, set);
            if (!stepper.ok()) {
                continue;
            }
            ShellState state = start;
            for (int i = 0; i < 5; ++i) {
                stepper.value().step(state, {}, Vec3::Zero(), 0.01, balanced, state);
            }
            reference = reference.position.empty() ? state : reference;
            CHECK(state.position == reference.position);
            CHECK(state.branch == reference.branch);
        }
        // another step size before, then the same as of a fresh stepper
        ShellStepper used = std::move(ShellStepper::create(model)).value();
        ShellState other = start;
        used.step(other, {}, Vec3::Zero(), 0.03, balanced, other);
        used.drop_caches();
        ShellState again = start;
        for (int i = 0; i < 5; ++i) {
            used.step(again, {}, Vec3::Zero(), 0.01, balanced, again);
        }
        CHECK(again.position == reference.position);
        CHECK(again.branch == reference.branch);
    }

    TEST_CASE("relaxation is slower in the cold as Arrhenius says, and what is none is refused") {
        const ShellRelaxation r{.time = 0.5, .reference_temperature = 23.0, .activation_energy = 1e5};
        CHECK(relaxation_time(r, 23.0) == doctest::Approx(0.5).epsilon(1e-14));
        const double by = 1e5 / 8.31446 * (1.0 / 291.15 - 1.0 / 296.15);
        CHECK(relaxation_time(r, 18.0) == doctest::Approx(0.5 * std::exp(by)).epsilon(1e-12));
        const double warm = 1e5 / 8.31446 * (1.0 / 310.15 - 1.0 / 296.15);
        CHECK(relaxation_time(r, 37.0) == doctest::Approx(0.5 * std::exp(warm)).epsilon(1e-12));
        const auto refused = [](const auto& change, const std::string& part) {
            ShellModel model = strip();
            change(model);
            const Status status = check_shell(model);
            REQUIRE_FALSE(status.ok());
            CHECK(status.error().text().find(part) != std::string::npos);
        };
        refused([](ShellModel& m) { m.relaxation->time = 0.0; }, "relaxation.time");
        refused([](ShellModel& m) { m.relaxation->branch_share = -1.0; }, "relaxation.branch_share");
        refused([](ShellModel& m) { m.relaxation->activation_energy = std::nan(""); }, "activation_energy");
        refused([](ShellModel& m) { m.relaxation->reference_temperature = 300.0; }, "reference_temperature");
        refused([](ShellModel& m) { m.temperature = -300.0; }, "temperature");
        refused([](ShellModel& m) { m.drag = -1.0; }, "drag");
        ShellState state = rest_state(strip());
        CHECK(check_shell_state(strip(), state).ok());
        state.branch.pop_back();
        CHECK_FALSE(check_shell_state(strip(), state).ok());
        state = rest_state(strip());
        state.branch[7] = std::nan("");
        CHECK_FALSE(check_shell_state(strip(), state).ok());
    }
}

TEST_SUITE("shell drag") {
    TEST_CASE("a sheet that sinks comes to the speed at which drag bears its weight, step by step as backward Euler") {
        ShellModel model = strip();
        model.drag = 2e-3;
        const Vec3 gravity(0.0, 0.0, -9810.0);
        const double per_area = model.material.density * 0.1;
        for (const ImplicitSettings& settings : {balanced, ImplicitSettings{.tolerance = 1e-10, .max_newton = 1}}) {
            ShellStepper stepper = std::move(ShellStepper::create(model)).value();
            ShellState state = rest_state(model);
            double speed = 0.0;
            for (int i = 0; i < 60; ++i) {
                stepper.step(state, {}, gravity, 0.05, settings, state);
                speed = (speed - 0.05 * 9810.0) / (1.0 + 0.05 * model.drag / per_area);
                CHECK(state.velocity[7].z() == doctest::Approx(speed).epsilon(1e-6));
            }
            CHECK(speed == doctest::Approx(-9810.0 * per_area / model.drag).epsilon(1e-3));
        }
    }

    TEST_CASE("a disc's is sixteen times viscosity, radius and speed") {
        // 1 Pa s, radius 3 mm, 1 mm/s: 48 uN, over pi 9 mm^2
        CHECK(disc_drag(1.0, 3.0) * M_PI * 9.0 == doctest::Approx(48.0));
    }
}
