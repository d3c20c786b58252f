// SPDX-License-Identifier: GPL-3.0-or-later
// Steps per second of the pulled sheet (tests/data/meshes/README.md): 10 ms, one linear solve to a relative residual of
// 1e-9.
#include "bench/bench_membrane.hpp"

#include <algorithm>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "physics/membrane/membrane_body.hpp"
#include "scenes/membranes.hpp"

namespace rhexis::bench {
namespace {

/// Thread CPU time of forces and stiffness at a state, median [s]: what a step costs though its solve cost nothing.
double assembly_seconds(const MembraneModel& model, const MembraneState& state, double dt) {
    MembraneBody body(model, state.sheet);
    std::vector<double> x(3 * at(body.rows()) + 1, 0.0);
    for (int row = 0; row < body.rows(); ++row) {
        Eigen::Map<Vec3>(x.data() + 3 * at(row)) = state.position[at(body.node_of()[at(row)])];
    }
    std::vector<double> force;
    BlockValues stiffness = zero_values(body.pattern());
    std::vector<double> seconds;
    for (int i = 0; i < 101; ++i) {
        const double start = thread_cpu_seconds();
        body.forces_and_stiffness(x, elastic_kernel::Mode::warped, dt * dt, force, stiffness);
        seconds.push_back(thread_cpu_seconds() - start);
    }
    std::nth_element(seconds.begin(), seconds.begin() + 50, seconds.end());
    return seconds[50];
}

nlohmann::json run_pulled(bool fibrous, const BenchOptions& options) {
    const std::string name = fibrous ? "capsule_1500/fibres" : "capsule_1500/isotropic";
    const Result<scenes::PulledSheet> scene = scenes::pulled_sheet(fibrous);
    if (!scene.ok()) {
        return {{"name", name}, {"error_text", scene.error().text()}};
    }
    scenes::HeldSheet sheet(scene.value().model);
    const ImplicitSettings settings{.tolerance = 1e-9, .max_newton = 1, .seldom_again = true};
    const int warm_up = options.quick ? 5 : scene.value().warm_up_steps;
    const int pieces = options.quick ? 1 : 8;
    const int each = options.quick ? 10 : scene.value().measured_steps / pieces;
    double time = 0.0;
    double residual = 0.0;
    double iterations = 0.0;
    int factored = 0;
    const auto advance = [&](int steps) {
        double seconds = 0.0;
        for (int i = 0; i < steps; ++i) {
            time += scene.value().step_s;
            const std::vector<Vec3> load = scenes::moving_load(scene.value(), time);
            const double start = thread_cpu_seconds();
            const ImplicitReport report = sheet.step(scene.value().step_s, load, settings);
            seconds += thread_cpu_seconds() - start;
            residual = std::max(residual, report.residual);
            iterations += report.linear_iterations;
            factored += report.factored ? 1 : 0;
        }
        return seconds / steps;
    };
    advance(warm_up);
    iterations = factored = 0;
    residual = 0.0;
    std::vector<double> seconds;
    for (int piece = 0; piece < pieces; ++piece) {
        seconds.push_back(advance(each));
    }
    std::sort(seconds.begin(), seconds.end());
    const double median = seconds[seconds.size() / 2];
    const double steps = static_cast<double>(pieces) * each;
    return {{"name", name},
            {"elements", scene.value().model.sheet->mesh.triangles.size()},
            {"nodes", scene.value().model.sheet->mesh.nodes.size()},
            {"steps_per_second", 1.0 / median},
            {"fastest_steps_per_second", 1.0 / seconds.front()},
            {"slowest_steps_per_second", 1.0 / seconds.back()},
            {"cpu_s_per_s", median / scene.value().step_s},
            {"assembly_share", assembly_seconds(scene.value().model, sheet.state(), scene.value().step_s) / median},
            {"iterations", iterations / steps},
            {"refactored", factored / steps},
            {"error", residual},
            {"error_kind", "largest relative residual of a step"}};
}

}  // namespace

std::vector<BenchCase> membrane_cases() {
    return {{"capsule_1500", "10 ms steps of a pulled sheet of 1,516 triangles, one solve to 1e-9",
             [](const BenchOptions& options) {
                 return nlohmann::json::array({run_pulled(false, options), run_pulled(true, options)});
             }}};
}

}  // namespace rhexis::bench
