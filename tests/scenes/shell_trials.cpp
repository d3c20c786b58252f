// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/shell_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "physics/shell/shell_motion.hpp"
#include "physics/shell/shell_statics.hpp"
#include "scenes/shell_problems.hpp"

namespace rhexis::scenes {
namespace {

ShellStatics statics_of(const ShellModel& model) { return std::move(ShellStatics::create(model)).value(); }
ShellStepper stepper_of(const ShellModel& model) { return std::move(ShellStepper::create(model)).value(); }

double apart(double value, double known) { return std::abs(value / known - 1.0); }

ShellLoad times(ShellLoad load, double factor) {
    for (Vec3& force : load.force) {
        force *= factor;
    }
    return load;
}

double fastest_node(const ShellState& state) {
    double most = 0.0;
    for (const Vec3& velocity : state.velocity) {
        most = std::max(most, velocity.norm());
    }
    return most;
}

constexpr int cylinder_loads = 8;
constexpr int cylinder_steps = 60;

/// A pulled cylinder of a soft shell in fluid, as light as an implant.
ShellProblem light_cylinder(int around, int along, GridCut cut) {
    ShellProblem cylinder = pulled_cylinder(around, along, cut);
    cylinder.model.material.density = 1e-3;
    cylinder.model.damping_mass = 50.0;
    return cylinder;
}

/// Where statics leads under each load.
std::vector<double> cylinder_rests(const ShellProblem& cylinder) {
    ShellStatics statics = statics_of(cylinder.model);
    ShellState state = rest_state(cylinder.model);
    std::vector<double> rests;
    for (int i = 1; i <= cylinder_loads; ++i) {
        const double from = static_cast<double>(i - 1) / cylinder_loads;
        const bool found =
            statics.load_to(cylinder.load, from, static_cast<double>(i) / cylinder_loads, {}, state).converged;
        rests.push_back(found ? cylinder.measure(state)[0] : NAN);
    }
    return rests;
}

/// One step as the world makes it.
void step_as_world(ShellStepper& stepper, ShellContacts& contacts, double dt, ShellState& state, CylinderRuns& runs,
                   int& flagged) {
    ShellPartners partners;
    partners.layers = false;
    const Vec3 weightless = Vec3::Zero();
    ShellState next;
    ShellStepReport report;
    const ShellTask task{state, partners, weightless, dt, {}};
    flagged += move_shell(stepper, contacts, task, next, report, runs.redone) == ShellMotion::balanced ? 0 : 1;
    runs.iterations += report.newton_iterations;
    state = std::move(next);
}

/// Under a load at once; returns where it ends.
double pull_one(const ShellProblem& cylinder, double factor, CylinderWay way, double dt, CylinderRuns& runs,
                int& flagged) {
    const ShellLoad load = times(cylinder.load, factor);
    ShellStepper stepper = stepper_of(cylinder.model);
    ShellContacts contacts(cylinder.model);
    ShellState state = rest_state(cylinder.model);
    state.loads.push_back({{0}, load.force[0]});
    const ImplicitSettings settings{.tolerance = 1e-3,
                                    .max_newton = 60,
                                    .newton_tolerance = 1e-4,
                                    .predict_stress = way == CylinderWay::predicted_stress};
    for (int i = 0; i < cylinder_steps; ++i) {
        if (way == CylinderWay::world) {
            step_as_world(stepper, contacts, dt, state, runs, flagged);
            continue;
        }
        const ImplicitReport report = stepper.step(state, load, Vec3::Zero(), dt, settings, state);
        runs.iterations += report.newton_iterations;
        flagged += report.converged ? 0 : 1;
    }
    return cylinder.measure(state)[0];
}

}  // namespace

FlatStart load_flat_ring() {
    const ShellProblem ring = slit_ring(30, 4);
    ShellStatics statics = statics_of(ring.model);
    ShellState at_once = rest_state(ring.model);
    ShellState in_parts = at_once;
    const ShellStaticReport whole = statics.load_to(ring.load, 0.0, 1.0, {}, at_once);
    FlatStart found{whole.iterations, whole.converged ? 0 : 1, 0.0};
    double factor = 0.0;
    for (const ShellProblem::Row& row : ring.reference) {
        found.unbalanced += statics.load_to(ring.load, factor, row.factor, {}, in_parts).converged ? 0 : 1;
        factor = row.factor;
    }
    found.apart = apart(ring.measure(at_once)[0], ring.measure(in_parts)[0]);
    return found;
}

FlatStart load_flat_strip(double dt) {
    ShellProblem strip = cantilever_shear(32, 2);
    strip.model.material.density = 1e-3;
    strip.model.damping_mass = 50.0;
    ShellStepper stepper = stepper_of(strip.model);
    ShellState state = rest_state(strip.model);
    FlatStart found;
    for (int i = 0; i < std::lround(1.0 / dt); ++i) {
        const ImplicitReport report = stepper.step(
            state, strip.load, Vec3::Zero(), dt,
            {.tolerance = 1e-3, .max_newton = 30, .newton_tolerance = 1e-4, .predict_stress = true}, state);
        found.iterations = i == 0 ? report.newton_iterations : found.iterations;
        found.unbalanced += report.converged ? 0 : 1;
    }
    found.apart = apart(strip.measure(state)[1], strip.reference.back().measure[1]);
    return found;
}

SnapPath follow_roof(int each_way) {
    constexpr double between = 15.0;  // deflection between the limit points [mm]
    constexpr double far = 29.0;
    const ShellProblem roof = hinged_roof(each_way, 12.7);
    ShellStatics statics = statics_of(roof.model);
    ShellPath path{rest_state(roof.model), 0.0, {}};
    SnapPath found{0.0, 1.0, false};
    for (int step = 0; step < 80 && !found.passed; ++step) {
        if (!statics.follow(roof.load, 8.0, {}, path).converged) {
            break;
        }
        const double w = roof.measure(path.state)[0];
        found.upper = w < between ? std::max(found.upper, path.factor) : found.upper;
        found.lower = w > between ? std::min(found.lower, path.factor) : found.lower;
        found.passed = w >= far;
    }
    return found;
}

SnapThrough snap_roof() {
    constexpr double factor = 0.85;  // above the limit point at 0.74
    ShellProblem roof = hinged_roof(8, 12.7);
    roof.model.material.density = 1e-3;
    roof.model.damping_mass = 0.3;
    const ShellLoad load = times(roof.load, factor);
    ShellStepper stepper = stepper_of(roof.model);
    ShellState state = rest_state(roof.model);
    SnapThrough found;
    double fastest = 0.0;
    for (int i = 0; i < 400; ++i) {
        const ImplicitReport report = stepper.step(
            state, load, Vec3::Zero(), 0.2, {.tolerance = 1e-3, .max_newton = 40, .newton_tolerance = 1e-6}, state);
        found.unbalanced += report.converged ? 0 : 1;
        fastest = std::max(fastest, fastest_node(state));
    }
    found.speed = fastest_node(state) / fastest;
    ShellStatics statics = statics_of(roof.model);
    ShellState rest = state;
    found.beyond = statics.equilibrate(roof.load, factor, {}, rest).converged && statics.negative_pivots(rest) == 0
                       ? roof.measure(state)[0] / roof.measure(rest)[0]
                       : NAN;
    found.beyond = roof.measure(state)[0] > 25.0 ? found.beyond : NAN;  // it lies before the jump
    return found;
}

CylinderRuns pull_cylinders(CylinderWay way, double dt, bool quick) {
    constexpr double same = 1e-3;
    struct Mesh {
        int around;
        int along;
        GridCut cut;
    };
    const std::array<Mesh, 4> meshes{{{12, 8, GridCut::alternate},
                                      {12, 8, GridCut::one_way},
                                      {16, 12, GridCut::alternate},
                                      {16, 12, GridCut::one_way}}};
    CylinderRuns runs;
    for (std::size_t m = 0; m < (quick ? 1 : meshes.size()); ++m) {
        const ShellProblem cylinder = light_cylinder(meshes[m].around, meshes[m].along, meshes[m].cut);
        const std::vector<double> rests = cylinder_rests(cylinder);
        for (int i = 1; i <= cylinder_loads; ++i) {
            int flagged = 0;
            const double end = pull_one(cylinder, static_cast<double>(i) / cylinder_loads, way, dt, runs, flagged);
            const bool there = apart(end, rests[at(i - 1)]) <= same;
            ++runs.runs;
            runs.elsewhere += there ? 0 : 1;
            runs.hidden += !there && flagged == 0 ? 1 : 0;
            runs.flagged += flagged;
        }
    }
    return runs;
}

}  // namespace rhexis::scenes
