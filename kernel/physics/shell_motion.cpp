// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell_motion.hpp"

#include <algorithm>
#include <cmath>

#include "physics/tool_shape.hpp"

namespace rhexis {
namespace {

constexpr int most_steps = 128;  // before any is redone

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

double farthest(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
    double square = 0.0;
    for (std::size_t n = 0; n < from.size(); ++n) {
        square = std::max(square, (to[n] - from[n]).squaredNorm());
    }
    return std::sqrt(square);
}

/// How far what carries a tube takes the corners of a box.
double way_of(const Box& box, const ToolState& carrier) {
    double way = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 place((corner & 1) != 0 ? box.high.x() : box.low.x(), (corner & 2) != 0 ? box.high.y() : box.low.y(),
                         (corner & 4) != 0 ? box.high.z() : box.low.z());
        way = std::max(way, (carrier.pose.to_world(carrier.previous_pose.to_body(place)) - place).norm());
    }
    return way;
}

/// Steps in which the instruments go no farther near the shell than contact allows.
int steps_for(const ShellContacts& contacts, const ShellTask& task) {
    Box box;
    for (const Vec3& place : task.state.position) {
        box.add(place, contacts.most_travel());
    }
    double way = 0.0;
    for (std::size_t i = 0; i < task.partners.tools.size(); ++i) {
        if (task.partners.tool_states[i].present) {
            way = std::max(way, travel_near(task.partners.tools[i], task.partners.tool_states[i], box));
        }
    }
    for (const ToolState& tube : task.partners.tube_states) {
        way = std::max(way, way_of(box, tube));
    }
    return std::clamp(static_cast<int>(std::ceil(way / contacts.most_travel())), 1, most_steps);
}

/// Whether every one of the steps balances and none goes too far.
bool run(ShellStepper& stepper, ShellContacts& contacts, const ShellTask& task, int steps, ShellState& state,
         ShellStepReport& report) {
    const ShellLoad load = load_of(task.state);
    report = ShellStepReport{};
    report.substeps = steps;
    bool balanced = true;
    std::vector<Vec3> before;
    for (int i = 0; i < steps; ++i) {
        ShellPartners partners = task.partners;
        partners.from = static_cast<double>(i) / steps;
        partners.to = static_cast<double>(i + 1) / steps;
        contacts.look(state, partners);
        before = state.position;
        ImplicitSettings own = settings;
        if (!contacts.empty()) {
            own.predict_stress = false;  // whole iterations jump over what touches
            own.most_travel = contacts.most_travel();
        }
        const ImplicitReport one = stepper.step(state, load, task.gravity, task.dt / steps, own, state, &contacts);
        report.newton_iterations += one.newton_iterations;
        report.linear_iterations += one.linear_iterations;
        report.residual = std::max(report.residual, one.newton_residual);
        if (!std::isfinite(one.newton_residual)) {
            report.residual = one.newton_residual;
            return false;
        }
        balanced = balanced && one.converged &&
                   (contacts.empty() || farthest(before, state.position) <= contacts.most_travel());
    }
    return balanced;
}

}  // namespace

ShellMotion move_shell(ShellStepper& stepper, ShellContacts& contacts, const ShellTask& task, ShellState& next,
                       ShellStepReport& report, int& rollbacks) {
    const int coarsest = steps_for(contacts, task);
    constexpr int finest = 16;
    for (const int finer : {1, 4, finest}) {
        next = task.state;
        if (run(stepper, contacts, task, coarsest * finer, next, report)) {
            return ShellMotion::balanced;
        }
        if (finer == finest && std::isfinite(report.residual)) {
            return ShellMotion::rough;
        }
        ++rollbacks;
        stepper.drop_caches();
    }
    next = task.state;
    stop(next);
    return ShellMotion::failed;
}

}  // namespace rhexis
