// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "bench/charts/models.hpp"
#include "bench/methods/nine_term_plate.hpp"
#include "bench/timing.hpp"
#include "physics/shell/shell_statics.hpp"
#include "scenes/shell_problems.hpp"

namespace rhexis::bench {
namespace {

constexpr std::array<std::array<int, 2>, 4> ring_meshes{{{30, 4}, {42, 4}, {62, 6}, {90, 10}}};
constexpr std::size_t usual_mesh = 1;  ///< 336 triangles: nearest to what the budget of exercises chooses

/// How far the lip is lifted by each load of the table; fewer where it does not converge.
std::vector<double> lifts(const scenes::ShellProblem& problem, const ShellTriangleMaker& maker, int& iterations) {
    ShellStatics statics = std::move(ShellStatics::create(problem.model, maker)).value();
    ShellState state = rest_state(problem.model);
    std::vector<double> found;
    double reached = 0.0;
    iterations = 0;
    for (const scenes::ShellProblem::Row& row : problem.reference) {
        const ShellStaticReport report = statics.load_to(problem.load, reached, row.factor, {}, state);
        iterations += report.iterations;
        if (!report.converged) {
            break;
        }
        reached = row.factor;
        found.push_back(problem.measure(state)[1]);
    }
    return found;
}

ChartPoint point_of_ring(const char* way, const ShellTriangleMaker& maker, std::size_t mesh, bool is_default,
                         int repeats) {
    const scenes::ShellProblem problem = scenes::slit_ring(ring_meshes[mesh][0], ring_meshes[mesh][1]);
    std::vector<double> answer;
    for (const scenes::ShellProblem::Row& row : problem.reference) {
        answer.push_back(row.measure[1]);
    }
    std::vector<double> found;
    int iterations = 1;
    const double seconds = time_interleaved({[&] { found = lifts(problem, maker, iterations); }}, repeats)[0].seconds;
    const std::string setting = std::to_string(problem.model.mesh.triangles.size()) + " triangles";
    return point_of(way, setting, is_default, rms_share(found, answer), seconds / std::max(iterations, 1));
}

std::vector<ChartPoint> measure_shell(const ChartOptions& options) {
    std::vector<ChartPoint> points;
    for (std::size_t mesh = 0; mesh < ring_meshes.size(); ++mesh) {
        const bool is_default = mesh == usual_mesh;
        if (is_default || !options.only_default) {
            points.push_back(
                point_of_ring("kernel: Kirchhoff triangle", shell_triangle, mesh, is_default, options.repeats));
        }
    }
    for (std::size_t mesh = 0; mesh < ring_meshes.size() && !options.only_default; ++mesh) {
        points.push_back(
            point_of_ring("nine-term plate [Dequidt2013]", nine_term_triangle, mesh, false, options.repeats));
    }
    return points;
}

}  // namespace

Chart chart_shell() {
    return {"shell",
            "A flat ring, slit, one lip clamped, the other lifted by 1.7 of its radius",
            "CPU seconds for one iteration of Newton's method",
            "lift of the lip, rms over the loads of the table",
            "table of [Sze2004]",
            true,
            measure_shell};
}

}  // namespace rhexis::bench
