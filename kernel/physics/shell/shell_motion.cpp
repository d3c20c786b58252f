// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_motion.hpp"

#include <algorithm>
#include <cmath>

#include "math/longest.hpp"
#include "physics/contact/tool_shape.hpp"
#include "physics/membrane/sheet_contact.hpp"
#include "physics/shell/shell_carry.hpp"

namespace rhexis {
namespace {

constexpr int most_steps = 128;       // before any is redone
constexpr double pushed_share = 0.8;  // of what contact allows: what an instrument pushes may go faster than it
constexpr double own_share = 0.9;     // likewise: what moves by itself, if it goes on as it does
constexpr int most_own = 4;           // steps for that
constexpr int pieces = 2;             // of one that is redone
constexpr int most_pieces = 4;        // of one that balances, and goes too far
constexpr int most_cuts = 4;          // of one into pieces, and of those
constexpr double least_way = 0.25;    // of what contact allows, that a node may go beyond what all go,
constexpr double more_way = 2.0;      // and as much more than if it went on as it does
/// What is left over the forces of contact that finer steps are worth while for, and Newton iterations in all of a step
/// after which none are: a lens that jams can cost twenty times as much by them and come no nearer to balance.
constexpr double near_balance = 1e-2;
constexpr int most_iterations = 300;
/// After so many the whole step is given up: an instrument that is thrust through a lens can ask for a hundred times as
/// many.
constexpr int hopeless = 1000;

constexpr ImplicitSettings settings{
    .tolerance = 1e-3, .max_newton = 30, .newton_tolerance = 1e-4, .predict_stress = true};

/// What is pushed goes on as it went. Whole iterations would jump over what touches. Newton's method takes no more of
/// them with solves to a tenth than to a thousandth.
constexpr ImplicitSettings in_contact{.tolerance = 0.1,
                                      .max_newton = 30,
                                      .newton_tolerance = 1e-4,
                                      .contact_tolerance = 1e-3,
                                      .predict = true,
                                      .quick_to_project = true,
                                      .search_to = 0.2};

/// With a membrane, whose folds never balance to the last: a hundredth of what holds the implant in its bag.
constexpr double wall_tolerance = 2.0;  // [uN]

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

/// Steps in which the instruments go no farther near the shell than contact allows, and near its wall, and neither do
/// both by themselves.
int steps_for(const ShellContacts& contacts, const ShellTask& task) {
    std::vector<Vec3> places = task.state.position;
    if (task.wall) {
        places.insert(places.end(), task.wall->state.position.begin(), task.wall->state.position.end());
    }
    Box box;
    for (const Vec3& place : places) {
        box.add(place, contacts.most_travel());
    }
    double way = 0.0;
    for (std::size_t i = 0; i < task.partners.tools.size(); ++i) {
        if (task.partners.tool_states[i].present) {
            const double own = travel_near(task.partners.tools[i], task.partners.tool_states[i], box);
            if (own > way &&
                (!task.wall || comes_near(task.partners.tools[i], task.partners.tool_states[i], own, places))) {
                way = own;
            }
        }
    }
    for (const ToolState& tube : task.partners.tube_states) {
        way = std::max(way, way_of(box, tube));
    }
    const double speed = std::max(longest(task.state.velocity), task.wall ? longest(task.wall->state.velocity) : 0.0);
    const double own = std::min(speed * task.dt / (own_share * contacts.most_travel()), 1.0 * most_own);
    const double pushed = way / (pushed_share * contacts.most_travel());
    return std::clamp(static_cast<int>(std::ceil(std::max(own, pushed))), 1, most_steps);
}

/// What moves.
struct Bodies {
    ShellState shell;
    MembraneState wall;
};

/// A step on its way.
struct Run {
    ShellStepper& stepper;
    ShellContacts& contacts;
    const ShellTask& task;
    ShellLoad load;
    ShellStepReport& report;
    int& rollbacks;
    ContactSet found;  ///< of the wall with instruments
    SheetContacts touching;
    std::vector<ToolState> tools;  ///< where they are in a piece of the step
    PartnerPoses poses;
};

/// What touches the wall in a piece of the step, besides the shell.
void look_at_wall(Run& run, double from, double to, const MembraneState& wall) {
    const WallTask& own = *run.task.wall;
    run.tools.clear();
    for (const ToolState& tool : own.tools) {
        run.tools.push_back(part_of_step(tool, from, to));
    }
    run.touching.look(own.world, own.membrane, wall, run.tools, (to - from) * run.task.dt);
    place_tools(run.tools, 1.0, run.poses);
    run.touching.place(run.poses);
}

ImplicitSettings settings_of(const Run& run) {
    if (run.contacts.empty() && !run.task.wall) {
        return settings;
    }
    ImplicitSettings own = in_contact;
    own.most_travel = run.contacts.most_travel();
    if (run.task.wall) {
        own.force_tolerance = wall_tolerance;
        own.rest_tolerance = 0.1 * wall_tolerance;
    }
    return own;
}

/// How far each node may go beyond what all go: layers that are pushed along together come no nearer to each other.
std::vector<double> ways_of(const Run& run, double dt, const ShellPartners& partners, const ShellState& state) {
    const double most = run.contacts.most_travel();
    const std::vector<Vec3> carried = carried_velocity(state, partners, dt);
    const auto goes = [&](std::size_t n) { return carried.empty() ? state.velocity[n] : carried[2 * n]; };
    const std::size_t nodes = state.position.size();
    Vec3 mean = Vec3::Zero();
    for (std::size_t n = 0; n < nodes; ++n) {
        mean += goes(n) / static_cast<double>(nodes);
    }
    std::vector<double> ways(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
        ways[n] = std::min(most, least_way * most + more_way * dt * (goes(n) - mean).norm());
    }
    return ways;
}

/// One solve from share `from` of the step to share `to`; `now` goes there.
ImplicitReport solve(Run& run, double from, double to, const ShellPartners& partners, Bodies& now) {
    const double dt = (to - from) * run.task.dt;
    std::vector<Vec3> guess = carried_velocity(now.shell, partners, dt);
    if (!run.task.wall) {
        return run.stepper.step(now.shell, run.load, run.task.gravity, dt, settings_of(run), now.shell, &run.contacts,
                                nullptr, std::move(guess));
    }
    look_at_wall(run, from, to, now.wall);
    const WallTask& own = *run.task.wall;
    ShellWall wall{own.world.membranes[static_cast<std::size_t>(own.membrane)], now.wall, now.wall, {}};
    if (!run.touching.empty()) {
        wall.touching = [&run](const std::vector<Vec3>& position, std::vector<ContactTerm>& terms) {
            run.touching.terms(position, terms);
        };
    }
    const ImplicitReport one = run.stepper.step(now.shell, run.load, run.task.gravity, dt, settings_of(run), now.shell,
                                                &run.contacts, &wall, std::move(guess));
    run.touching.settle(now.wall.position, run.poses, dt);
    run.touching.report(run.task.dt, run.found);
    now.wall.touches = run.touching.touches();
    return one;
}

ImplicitReport solve_counted(Run& run, double from, double to, const ShellPartners& partners, Bodies& now) {
    const ImplicitReport one = solve(run, from, to, partners, now);
    run.report.newton_iterations += one.newton_iterations;
    run.report.linear_iterations += one.linear_iterations;
    return one;
}

/// Of one step: whether it balances and goes no farther than contact allows, or is worth keeping as it is.
struct Try {
    bool good = false;
    bool safe = false;  ///< it goes no farther than that
    bool near = false;  ///< to balance
    bool balanced = false;
    double way = 0.0;      ///< of what went farthest, over what contact allows
    double deepest = 0.0;  ///< penetration over thickness
    double residual = 0.0;
};

/// From share `from` of the step to share `to` in one; `now` goes there.
Try step_once(Run& run, double from, double to, Bodies& now) {
    ShellPartners partners = run.task.partners;
    partners.from = from;
    partners.to = to;
    if (run.task.wall) {
        partners.sheet = &now.wall;
        partners.sheet_model = &run.task.wall->world.membranes[static_cast<std::size_t>(run.task.wall->membrane)];
    }
    const Bodies before = now;
    const std::size_t found = run.found.size();
    std::vector<double> ways;
    if (partners.layers) {
        ways = ways_of(run, (to - from) * run.task.dt, partners, now.shell);
    }
    run.contacts.look(now.shell, partners, std::move(ways));
    ImplicitReport one = solve_counted(run, from, to, partners, now);
    if (std::isfinite(one.newton_residual) && run.contacts.went_too_far(before.shell.position, now.shell.position)) {
        now = before;
        run.found.resize(found);
        run.contacts.look(now.shell, partners);
        one = solve_counted(run, from, to, partners, now);
    }
    const double residual = std::min(one.newton_residual, one.over_contact);
    const double way = std::max(farthest(before.shell.position, now.shell.position),
                                farthest(before.wall.position, now.wall.position));
    const bool safe = run.contacts.empty() || way <= run.contacts.most_travel();
    const bool near = run.task.wall && one.over_contact <= near_balance;
    return {one.converged && safe,  safe,    near, one.converged, way / run.contacts.most_travel(),
            run.contacts.deepest(), residual};
}

/// What goes too far in a step goes a little farther in its pieces together.
int pieces_for(const Try& tried) {
    return tried.balanced ? std::clamp(static_cast<int>(std::ceil(1.2 * tried.way)), pieces, most_pieces) : pieces;
}

/// The same in as many steps as it takes, where it takes them.
ShellMotion go(Run& run, double from, double to, int cuts, Bodies& now) {
    const Bodies start = now;
    const std::size_t found = run.found.size();
    const Try tried = step_once(run, from, to, now);
    const bool enough = tried.safe && (tried.near || run.report.newton_iterations > most_iterations);
    if (tried.good || ((enough || cuts == 0) && std::isfinite(tried.residual))) {
        ++run.report.substeps;
        run.report.deepest = std::max(run.report.deepest, tried.deepest);
        run.report.residual = std::max(run.report.residual, tried.residual);
        return tried.good ? ShellMotion::balanced : ShellMotion::rough;
    }
    ++run.rollbacks;
    run.found.resize(found);
    run.stepper.drop_factor();
    if (cuts == 0 || run.report.newton_iterations > hopeless) {
        return ShellMotion::failed;
    }
    now = start;
    ShellMotion worst = ShellMotion::balanced;
    const int parts = pieces_for(tried);
    for (int i = 0; i < parts && worst != ShellMotion::failed; ++i) {
        const double share = (to - from) / parts;
        worst = std::max(worst, go(run, from + i * share, from + (i + 1) * share, cuts - 1, now));
    }
    return worst;
}

}  // namespace

ShellMotion move_shell(ShellStepper& stepper, ShellContacts& contacts, const ShellTask& task, ShellState& next,
                       ShellStepReport& report, int& rollbacks) {
    report = ShellStepReport{};
    report.substeps = 0;
    Run run{stepper, contacts, task, load_of(task.state), report, rollbacks, {}, {}, {}, {}};
    Bodies now{task.state, task.wall ? task.wall->state : MembraneState{}};
    const int steps = steps_for(contacts, task);
    ShellMotion worst = ShellMotion::balanced;
    for (int i = 0; i < steps && worst != ShellMotion::failed; ++i) {
        worst = std::max(worst,
                         go(run, static_cast<double>(i) / steps, static_cast<double>(i + 1) / steps, most_cuts, now));
    }
    if (worst == ShellMotion::failed) {
        now = {task.state, task.wall ? task.wall->state : MembraneState{}};
        stop(now.shell);
        now.wall.velocity.assign(now.wall.velocity.size(), Vec3::Zero());
        run.found.clear();
    }
    next = std::move(now.shell);
    if (task.wall) {
        task.wall->next = std::move(now.wall);
        task.wall->contacts.insert(task.wall->contacts.end(), run.found.begin(), run.found.end());
    }
    return worst;
}

}  // namespace rhexis
