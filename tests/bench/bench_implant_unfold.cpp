// SPDX-License-Identifier: GPL-3.0-or-later
// The foldable lens, held folded for long and let go: how long it takes to unfold, by step, viscosity, temperature and
// fluid.
#include <algorithm>
#include <optional>
#include <string>

#include "base/clock.hpp"
#include "bench/bench_shell.hpp"
#include "physics/shell/shell_energy.hpp"
#include "physics/shell/shell_stepper.hpp"
#include "scenes/shells.hpp"

namespace rhexis::bench {
namespace {

constexpr double saline = 1e-3;     // [Pa s]
constexpr double ovd = 200.0;       // a cohesive viscoelastic nearly at rest [Pa s]
constexpr double fold_force = 4e4;  // on either side [uN]
constexpr double unfolded = 0.1;    // share of the fold that is left

struct Unfolding {
    std::string name;
    bool viscous = true;
    double temperature = 23.0;  // [C]
    double fluid = saline;      // [Pa s]
    double dt = 0.01;           // [s]
    double longest = 60.0;      // [s]
};

/// Folded to equilibrium, its branch at rest: as after a time much longer than it takes to relax.
struct Folded {
    scenes::FoldedOptic optic;
    ShellState state;
    double degrees = 0.0;
    double edge_x = 0.0;  // [mm]
};

Folded fold(int triangles) {
    Folded folded{scenes::folded_optic(triangles), {}, 0.0, 0.0};
    folded.state = scenes::folded_state(folded.optic, fold_force);
    folded.degrees = scenes::fold_degrees(folded.optic, folded.state);
    folded.edge_x = folded.state.position[static_cast<std::size_t>(folded.optic.edge)].x();
    return folded;
}

nlohmann::json unfold(const Folded& folded, const Unfolding& how) {
    scenes::FoldedOptic optic = folded.optic;
    ShellModel& model = optic.implant.model;
    if (how.viscous) {
        model.relaxation = ShellRelaxation{};
    }
    model.temperature = how.temperature;
    model.drag = disc_drag(how.fluid, 3.0);
    ShellState state = folded.state;
    state.branch = rest_state(model).branch;
    ShellStepper stepper = std::move(ShellStepper::create(model)).value();
    const ShellLedger ledger(model);
    const double start = ledger.energy(state).all();
    const double goal = unfolded * folded.degrees;
    double angle = folded.degrees;
    double time = 0.0;
    double seconds = 0.0;
    double iterations = 0.0;
    double worst = 0.0;
    int steps = 0;
    ShellStepEnergy taken;
    std::optional<double> done;
    while (!done && time < how.longest) {
        const ShellState before = state;
        const double begun = thread_cpu_seconds();
        const ImplicitReport report = stepper.step(
            before, {}, Vec3::Zero(), how.dt,
            {.tolerance = 1e-3, .max_newton = 60, .newton_tolerance = 1e-5, .predict_stress = true}, state);
        seconds += thread_cpu_seconds() - begun;
        const ShellStepEnergy e = ledger.step(before, state, {}, Vec3::Zero(), how.dt);
        taken.viscosity += e.viscosity;
        taken.drag += e.drag;
        taken.integrator += e.integrator;
        worst = std::max(worst, report.newton_residual);
        iterations += report.newton_iterations;
        ++steps;
        const double now = scenes::fold_degrees(optic, state);
        if (now <= goal) {
            done = time + how.dt * (angle - goal) / (angle - now);
        }
        angle = now;
        time += how.dt;
    }
    return {{"name", how.name},
            {"viscous", how.viscous},
            {"elements", model.mesh.triangles.size()},
            {"step_s", how.dt},
            {"temperature_C", how.temperature},
            {"fluid_Pa_s", how.fluid},
            {"fold_deg", folded.degrees},
            {"edge_x_mm", folded.edge_x},
            {"unfolded_s", done ? nlohmann::json(*done) : nlohmann::json()},
            {"stored_nJ", start},
            {"to_viscosity", taken.viscosity / start},
            {"to_drag", taken.drag / start},
            {"to_integrator", taken.integrator / start},
            {"cpu_s_per_s", seconds / time},
            {"newton_iterations", iterations / steps},
            {"error", worst},
            {"error_kind", "largest relative residual of a step"}};
}

std::vector<Unfolding> unfoldings(bool quick) {
    std::vector<Unfolding> all;
    for (const bool viscous : {true, false}) {
        for (const double dt : {0.01, 0.005, 0.0025}) {
            all.push_back({viscous ? "implant_unfold/viscous" : "implant_unfold/elastic", viscous, 23.0, saline, dt,
                           quick ? 0.1 : 60.0});
        }
    }
    if (!quick) {
        for (const double temperature : {18.0, 37.0}) {
            all.push_back({"implant_unfold/temperature", true, temperature});
        }
        for (const bool viscous : {true, false}) {
            all.push_back({"implant_unfold/ovd", viscous, 23.0, ovd});
        }
    }
    return all;
}

}  // namespace

std::vector<BenchCase> implant_unfold_cases() {
    return {{"implant_unfold", "the foldable lens held folded for long and let go: time to nine tenths unfolded",
             [](const BenchOptions& options) {
                 const Folded folded = fold(743);
                 nlohmann::json rows = nlohmann::json::array();
                 for (const Unfolding& how : unfoldings(options.quick)) {
                     rows.push_back(unfold(folded, how));
                 }
                 return rows;
             }}};
}

}  // namespace rhexis::bench
