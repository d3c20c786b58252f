// SPDX-License-Identifier: GPL-3.0-or-later
// A folded implant pushed into the bag by a hand that holds still, by triangles of the bag and of the implant and by
// step.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "bench/bench_shell.hpp"
#include "physics/physics.hpp"
#include "session/build_world.hpp"
#include "session/implant_fold.hpp"

namespace rhexis::bench {
namespace {

constexpr double speed = 5.0;      // of the plunger [mm/s]
constexpr double unfolding = 6.0;  // looked at after the hand has come to the end of the stroke [s]
const Vec3 tip(0.0, -1.0, 1.2);    // in the near half of the opening [mm]

struct Case {
    double bag = 800.0;      ///< triangles
    double implant = 400.0;  ///< likewise
    double dt = 0.02;        ///< [s]
};

SceneDescription scene_of(const Case& own) {
    SceneDescription scene;
    scene.tissues = {"implant", "bag", "viscoelastic"};
    scene.instruments = {"injector"};
    scene.settings = {{"bag.triangles", own.bag}, {"implant.triangles", own.implant}, {"cartridge.tucked", 0.0}};
    return scene;
}

ShellState folded(const SceneDescription& scene) {
    ImplantFold fold = std::move(ImplantFold::create(folding_scene(scene.settings))).value();
    while (!fold.done() && fold.step()) {
    }
    return std::move(fold.result()).value().snapshot.world.shells[0];
}

/// The shaft rises by 25 degrees towards the surgeon.
Quat held() {
    Mat3 axes;
    axes.col(0) = Vec3::UnitX();
    axes.col(2) = Vec3(0.0, -0.9063, 0.4226).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return Quat(axes).normalized();
}

double stretched(const MembraneModel& model, const MembraneState& bag) {
    const std::vector<std::vector<int>> loops = boundary_loops(model.sheet->mesh, model.sheet->neighbours);
    double rest = 0.0;
    double now = 0.0;
    for (std::size_t i = 0; i < loops[0].size(); ++i) {
        const std::size_t a = at(loops[0][i]);
        const std::size_t b = at(loops[0][(i + 1) % loops[0].size()]);
        rest += (model.sheet->mesh.nodes[a] - model.sheet->mesh.nodes[b]).norm();
        now += (bag.position[a] - bag.position[b]).norm();
    }
    return now / rest;
}

nlohmann::json row(const Case& own) {
    const SceneDescription scene = scene_of(own);
    const std::shared_ptr<const WorldModel> model = std::move(build_world(scene)).value().world;
    Physics physics = std::move(Physics::create(model, {})).value();
    WorldState state = rest_state(*model);
    state.shells[0] = folded(scene);
    ToolState hand;
    hand.present = true;
    hand.pose = {tip, held()};
    hand.previous_pose = hand.pose;
    const int pushing = static_cast<int>(model->tools[0].cartridge->stroke / speed / own.dt) + 1;
    const int steps = pushing + static_cast<int>(unfolding / own.dt);
    std::vector<double> iterations;
    double deepest = 0.0;
    double residual = 0.0;
    double rim = 1.0;
    int redone = 0;
    const double start = thread_cpu_seconds();
    for (int i = 0; i < steps; ++i) {
        hand.previous_jaw = hand.jaw;
        hand.jaw = std::min(1.0, hand.jaw + 1.0 / pushing);
        WorldState next;
        ContactSet contacts;
        Profile profile;
        const StepOutcome outcome = physics.advance(state, {&hand, 1}, own.dt, next, contacts, profile);
        iterations.push_back(outcome.shells[0].newton_iterations);
        deepest = std::max(deepest, outcome.shells[0].deepest);
        residual = std::max(residual, outcome.shells[0].residual);
        redone += outcome.rollbacks;
        state = std::move(next);
        rim = std::max(rim, stretched(model->membranes[0], state.membranes[0]));
    }
    const double cpu = thread_cpu_seconds() - start;
    Vec3 middle = Vec3::Zero();
    for (const Vec3& place : state.shells[0].position) {
        middle += place / static_cast<double>(state.shells[0].position.size());
    }
    std::sort(iterations.begin(), iterations.end());
    const auto rank = [&](double share) {
        return iterations[static_cast<std::size_t>(share * static_cast<double>(iterations.size() - 1))];
    };
    return {{"name", "implant_bag"},
            {"elements", model->membranes[0].sheet->mesh.triangles.size() + model->shells[0].mesh.triangles.size()},
            {"bag", own.bag},
            {"implant", own.implant},
            {"step_ms", 1e3 * own.dt},
            {"x_mm", middle.x()},
            {"y_mm", middle.y()},
            {"z_mm", middle.z()},
            {"rim_stretch", rim},
            {"redone", redone},
            {"residual", residual},
            {"iterations_p50", rank(0.5)},
            {"iterations_p99", rank(0.99)},
            {"cpu_s_per_s", cpu / (steps * own.dt)},
            {"error", deepest},
            {"error_kind", "deepest penetration over thickness"}};
}

}  // namespace

std::vector<BenchCase> implant_bag_cases() {
    const std::vector<Case> cases{{}, {.bag = 400.0}, {.bag = 1600.0}, {.dt = 0.01}, {.implant = 743.0}};
    return {{"implant_bag", "a folded implant pushed into the bag, by triangles of both and by step",
             [cases](const BenchOptions& options) {
                 nlohmann::json rows = nlohmann::json::array();
                 for (std::size_t i = 0; i < (options.quick ? 1 : cases.size()); ++i) {
                     rows.push_back(row(cases[i]));
                 }
                 return rows;
             }}};
}

}  // namespace rhexis::bench
