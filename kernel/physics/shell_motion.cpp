// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell_motion.hpp"

#include <algorithm>
#include <cmath>

#include "physics/tool_shape.hpp"

namespace rhexis {
namespace {

constexpr int most_steps = 128;       // before any is redone
constexpr double pushed_share = 0.8;  // of what contact allows: what an instrument pushes may go faster than it
constexpr int pieces = 4;             // of one that is redone
constexpr int most_cuts = 2;          // of one into pieces, and of those
/// What is left over the forces of contact that finer steps are worth while for, and Newton iterations in all of a step
/// after which none are: a lens that jams can cost twenty times as much by them and come no nearer to balance.
constexpr double near_balance = 1e-2;
constexpr int most_iterations = 150;

constexpr ImplicitSettings settings{
    .tolerance = 1e-3, .max_newton = 30, .newton_tolerance = 1e-4, .predict_stress = true};

/// What is pushed goes on as it went. Whole iterations would jump over what touches. Newton's method takes no more of
/// them with solves to a tenth than to a thousandth.
constexpr ImplicitSettings in_contact{.tolerance = 0.1,
                                      .max_newton = 30,
                                      .newton_tolerance = 1e-4,
                                      .contact_tolerance = 1e-3,
                                      .predict = true,
                                      .quick_to_project = true};

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
    return std::clamp(static_cast<int>(std::ceil(way / (pushed_share * contacts.most_travel()))), 1, most_steps);
}

/// A step on its way.
struct Run {
    ShellStepper& stepper;
    ShellContacts& contacts;
    const ShellTask& task;
    ShellLoad load;
    ShellStepReport& report;
    int& rollbacks;
};

/// Of one step: whether it balances and goes no farther than contact allows, or is worth keeping as it is.
struct Try {
    bool good = false;
    bool safe = false;  ///< it goes no farther than that
    bool near = false;  ///< to balance
    double residual = 0.0;
};

/// From share `from` of the step to share `to` in one; `state` goes there.
Try step_once(Run& run, double from, double to, ShellState& state) {
    ShellPartners partners = run.task.partners;
    partners.from = from;
    partners.to = to;
    run.contacts.look(state, partners);
    ImplicitSettings own = settings;
    if (!run.contacts.empty()) {
        own = in_contact;
        own.most_travel = run.contacts.most_travel();
    }
    const std::vector<Vec3> before = state.position;
    const ImplicitReport one =
        run.stepper.step(state, run.load, run.task.gravity, (to - from) * run.task.dt, own, state, &run.contacts);
    run.report.newton_iterations += one.newton_iterations;
    run.report.linear_iterations += one.linear_iterations;
    const double residual = std::min(one.newton_residual, one.over_contact);
    const bool safe = run.contacts.empty() || farthest(before, state.position) <= run.contacts.most_travel();
    return {one.converged && safe, safe, one.over_contact <= near_balance, residual};
}

/// The same in as many steps as it takes, where it takes them.
ShellMotion go(Run& run, double from, double to, int cuts, ShellState& state) {
    const ShellState start = state;
    const Try tried = step_once(run, from, to, state);
    const bool enough = tried.safe && (tried.near || run.report.newton_iterations > most_iterations);
    if (tried.good || ((enough || cuts == 0) && std::isfinite(tried.residual))) {
        ++run.report.substeps;
        run.report.residual = std::max(run.report.residual, tried.residual);
        return tried.good ? ShellMotion::balanced : ShellMotion::rough;
    }
    ++run.rollbacks;
    run.stepper.drop_factor();
    if (cuts == 0) {
        return ShellMotion::failed;
    }
    state = start;
    ShellMotion worst = ShellMotion::balanced;
    for (int i = 0; i < pieces && worst != ShellMotion::failed; ++i) {
        const double share = (to - from) / pieces;
        worst = std::max(worst, go(run, from + i * share, from + (i + 1) * share, cuts - 1, state));
    }
    return worst;
}

}  // namespace

ShellMotion move_shell(ShellStepper& stepper, ShellContacts& contacts, const ShellTask& task, ShellState& next,
                       ShellStepReport& report, int& rollbacks) {
    report = ShellStepReport{};
    report.substeps = 0;
    Run run{stepper, contacts, task, load_of(task.state), report, rollbacks};
    next = task.state;
    const int steps = steps_for(contacts, task);
    ShellMotion worst = ShellMotion::balanced;
    for (int i = 0; i < steps && worst != ShellMotion::failed; ++i) {
        worst = std::max(worst,
                         go(run, static_cast<double>(i) / steps, static_cast<double>(i + 1) / steps, most_cuts, next));
    }
    if (worst == ShellMotion::failed) {
        next = task.state;
        stop(next);
    }
    return worst;
}

}  // namespace rhexis
