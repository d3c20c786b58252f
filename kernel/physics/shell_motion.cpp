// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell_motion.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {
namespace {

constexpr ImplicitSettings settings{
    .tolerance = 1e-3, .max_newton = 30, .newton_tolerance = 1e-4, .predict_stress = true};

ShellLoad load_of(const ShellState& state) {
    ShellLoad load;
    if (state.loads.empty()) {
        return load;
    }
    load.force.assign(state.position.size(), Vec3::Zero());
    for (const ShellPull& pull : state.loads) {
        for (const int node : pull.nodes) {
            load.force[static_cast<std::size_t>(node)] += pull.total / static_cast<double>(pull.nodes.size());
        }
    }
    return load;
}

void stop(ShellState& state) {
    std::fill(state.velocity.begin(), state.velocity.end(), Vec3(Vec3::Zero()));
    std::fill(state.spin.begin(), state.spin.end(), Vec3(Vec3::Zero()));
}

/// Whether every one of the steps balances.
bool run(ShellStepper& stepper, const ShellLoad& load, const Vec3& gravity, double dt, int steps, ShellState& state,
         ShellStepReport& report) {
    report = ShellStepReport{};
    report.substeps = steps;
    bool balanced = true;
    for (int i = 0; i < steps; ++i) {
        const ImplicitReport one = stepper.step(state, load, gravity, dt / steps, settings, state);
        report.newton_iterations += one.newton_iterations;
        report.linear_iterations += one.linear_iterations;
        report.residual = std::max(report.residual, one.newton_residual);
        balanced = balanced && one.converged;
        if (!std::isfinite(one.newton_residual)) {
            report.residual = one.newton_residual;
            return false;
        }
    }
    return balanced;
}

}  // namespace

ShellMotion move_shell(ShellStepper& stepper, const ShellState& state, const Vec3& gravity, double dt, ShellState& next,
                       ShellStepReport& report, int& rollbacks) {
    const ShellLoad load = load_of(state);
    constexpr int finest = 16;
    for (const int steps : {1, 4, finest}) {
        next = state;
        if (run(stepper, load, gravity, dt, steps, next, report)) {
            return ShellMotion::balanced;
        }
        if (steps == finest && std::isfinite(report.residual)) {
            return ShellMotion::rough;
        }
        ++rollbacks;
        stepper.drop_caches();
    }
    next = state;
    stop(next);
    return ShellMotion::failed;
}

}  // namespace rhexis
