// SPDX-License-Identifier: GPL-3.0-or-later
// A folded implant pushed into the bag by a hand that holds still, by triangles of the bag and of the implant and by
// step.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "bench/bench_shell.hpp"
#include "scenes/bag_injection.hpp"

namespace rhexis::bench {
namespace {

using Case = scenes::BagInjectionCase;

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

/// What a run came to.
struct Injected {
    int triangles = 0;
    std::vector<Vec3> places;  ///< of the implant's nodes [mm]
    std::vector<double> iterations;
    double deepest = 0.0;
    double residual = 0.0;
    double rim = 1.0;
    int redone = 0;
    double cpu = 0.0;  ///< a simulated second [s]
};

Vec3 middle(const std::vector<Vec3>& places) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& place : places) {
        sum += place;
    }
    return sum / static_cast<double>(places.size());
}

Injected inject(const Case& own) {
    scenes::BagInjection scene(own);
    const WorldModel& model = *scene.model;
    Injected result;
    const double start = thread_cpu_seconds();
    for (int i = 0; i < scene.steps(); ++i) {
        const StepOutcome outcome = scene.step();
        result.iterations.push_back(outcome.shells[0].newton_iterations);
        result.deepest = std::max(result.deepest, outcome.shells[0].deepest);
        result.residual = std::max(result.residual, outcome.shells[0].residual);
        result.redone += outcome.rollbacks;
        result.rim = std::max(result.rim, stretched(model.membranes[0], scene.state.membranes[0]));
    }
    result.cpu = (thread_cpu_seconds() - start) / (scene.steps() * own.dt);
    result.triangles =
        static_cast<int>(model.membranes[0].sheet->mesh.triangles.size() + model.shells[0].mesh.triangles.size());
    result.places = scene.state.shells[0].position;
    std::sort(result.iterations.begin(), result.iterations.end());
    return result;
}

double rank(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

nlohmann::json row(const char* name, const Case& own, const Injected& run) {
    return {{"name", name},
            {"elements", run.triangles},
            {"bag", own.bag},
            {"implant", own.implant},
            {"step_ms", 1e3 * own.dt},
            {"stiffer", own.contact.stiffer},
            {"onset", own.contact.onset},
            {"stick", own.contact.stick},
            {"x_mm", middle(run.places).x()},
            {"y_mm", middle(run.places).y()},
            {"z_mm", middle(run.places).z()},
            {"rim_stretch", run.rim},
            {"redone", run.redone},
            {"residual", run.residual},
            {"iterations", std::accumulate(run.iterations.begin(), run.iterations.end(), 0.0)},
            {"iterations_p50", rank(run.iterations, 0.5)},
            {"iterations_p99", rank(run.iterations, 0.99)},
            {"cpu_s_per_s", run.cpu},
            {"deepest", run.deepest},
            {"error", run.deepest},
            {"error_kind", "deepest penetration over thickness"}};
}

double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] - b[i]).norm();
    }
    return sum / static_cast<double>(a.size());
}

/// Ways to press and to stick, against hard springs that hardly give way: how far the implant's nodes end from where
/// they end then, in the mean.
nlohmann::json springs() {
    constexpr double looked_at = 3.0;  // after the end of the stroke: later all of them creep the same way [s]
    const auto of = [](double stiffer, double onset, double stick) {
        return Case{.unfolding = looked_at,
                    .contact = {.stiffer = stiffer, .stiffer_sheet = 10.0 * stiffer, .onset = onset, .stick = stick}};
    };
    const std::vector<Case> cases{
        of(80.0, 0.1, 1.0),   of(5.0, 0.01, 1.0),   of(20.0, 0.1, 1.0),   of(20.0, 0.1, 0.1),   of(20.0, 0.1, 0.02),
        of(20.0, 0.1, 0.006), of(20.0, 0.1, 0.002), of(80.0, 0.1, 0.006), of(40.0, 0.2, 0.006), of(10.0, 0.05, 0.01)};
    nlohmann::json rows = nlohmann::json::array();
    std::vector<Vec3> reference;
    for (const Case& own : cases) {
        const Injected run = inject(own);
        if (reference.empty()) {
            reference = run.places;
        }
        nlohmann::json one = row("implant_bag_springs", own, run);
        one["error"] = apart(run.places, reference);
        one["error_kind"] = "mean distance of nodes from where hard springs bring them [mm]";
        rows.push_back(std::move(one));
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> implant_bag_cases() {
    const std::vector<Case> cases{{}, {.bag = 400.0}, {.bag = 1600.0}, {.dt = 0.01}, {.implant = 743.0}};
    return {{"implant_bag", "a folded implant pushed into the bag, by triangles of both and by step",
             [cases](const BenchOptions& options) {
                 nlohmann::json rows = nlohmann::json::array();
                 for (std::size_t i = 0; i < (options.quick ? 1 : cases.size()); ++i) {
                     options.progress(static_cast<double>(i) / static_cast<double>(cases.size()));
                     rows.push_back(row("implant_bag", cases[i], inject(cases[i])));
                 }
                 return rows;
             }},
            {"implant_bag_springs", "the same by springs of contact: how hard they press and how hard they stick",
             [](const BenchOptions&) { return springs(); }}};
}

}  // namespace rhexis::bench
