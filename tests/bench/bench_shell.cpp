// SPDX-License-Identifier: GPL-3.0-or-later
// Reference problems of thin shells on ever finer meshes: error, iterations and time.
#include "bench/bench_shell.hpp"

#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "physics/shell/shell_statics.hpp"
#include "scenes/shell_problems.hpp"

namespace rhexis::bench {
namespace {

using scenes::ShellProblem;

/// Largest difference over the rows, of the largest value of that measure.
double relative_error(const std::array<double, 2>& value, const std::array<double, 2>& reference) {
    double error = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
        if (reference[k] != 0.0) {
            error = std::max(error, std::abs(value[k] - reference[k]) / std::abs(reference[k]));
        }
    }
    return error;
}

void add_rows(const ShellProblem& problem, nlohmann::json& rows) {
    Result<ShellStatics> statics = ShellStatics::create(problem.model);
    if (!statics.ok()) {
        rows.push_back({{"name", problem.name}, {"error_text", statics.error().text()}});
        return;
    }
    ShellState state = rest_state(problem.model);
    double factor = 0.0;
    for (const ShellProblem::Row& row : problem.reference) {
        const double start = thread_cpu_seconds();
        const ShellStaticReport report = statics.value().load_to(problem.load, factor, row.factor, {}, state);
        const double seconds = thread_cpu_seconds() - start;
        factor = row.factor;
        const std::array<double, 2> value = problem.measure(state);
        rows.push_back({{"name", problem.name},
                        {"elements", problem.model.mesh.triangles.size()},
                        {"nodes", problem.model.mesh.nodes.size()},
                        {"factor", row.factor},
                        {"first", value[0]},
                        {"second", value[1]},
                        {"first_reference", row.measure[0]},
                        {"second_reference", row.measure[1]},
                        {"iterations", report.iterations},
                        {"negative_pivots", report.negative_pivots},
                        {"cpu_s", seconds},
                        {"error", report.converged ? relative_error(value, row.measure) : HUGE_VAL},
                        {"error_kind", "largest relative difference of the two measures"}});
        if (!report.converged) {
            return;
        }
    }
}

/// Loads of the flat ring by Newton's method with tangents of either stress: stride of a fortieth of the load at first,
/// half as much again after each success, half after each failure.
nlohmann::json newton_row(const ShellProblem& problem, bool predict) {
    ShellStatics statics = std::move(ShellStatics::create(problem.model)).value();
    ShellState state = rest_state(problem.model);
    const ShellStaticSettings settings{.max_iterations = 60, .predict = predict};
    double factor = 0.0;
    double stride = 0.025;
    int iterations = 0;
    int loads = 0;
    while (factor < 1.0 && stride > 1e-6) {
        const double goal = std::min(1.0, factor + stride);
        const ShellStaticReport report = statics.equilibrate(problem.load, goal, settings, state);
        iterations += report.iterations;
        ++loads;
        factor = report.converged ? goal : factor;
        stride *= report.converged ? 1.5 : 0.5;
    }
    return {{"name", predict ? "shell_newton/predicted" : "shell_newton/true"},
            {"elements", problem.model.mesh.triangles.size()},
            {"loads", loads},
            {"iterations", iterations},
            {"first", problem.measure(state)[0]},
            {"error", 1.0 - factor},
            {"error_kind", "share of the load that was not reached"}};
}

}  // namespace

std::vector<BenchCase> shell_cases() {
    const auto one = [](const std::string& name, const std::string& summary, auto make) {
        return BenchCase{name, summary, [make](const BenchOptions& options) {
                             nlohmann::json rows = nlohmann::json::array();
                             for (int fineness = 0; fineness < (options.quick ? 1 : 3); ++fineness) {
                                 add_rows(make(fineness), rows);
                             }
                             return rows;
                         }};
    };
    using namespace scenes;
    return {one("shell_cantilever", "strip bent by an end shear, against the elastica",
                [](int k) {
                    return cantilever_shear(std::array{8, 16, 92}[static_cast<std::size_t>(k)],
                                            std::array{1, 2, 4}[static_cast<std::size_t>(k)]);
                }),
            one("shell_moment", "strip rolled up by an end moment, against the circle",
                [](int k) { return cantilever_moment(16 << k, 2 << k); }),
            one("shell_ring", "slit ring, lifted",
                [](int k) {
                    return slit_ring(std::array{30, 62, 90}[static_cast<std::size_t>(k)],
                                     std::array{4, 6, 10}[static_cast<std::size_t>(k)]);
                }),
            one("shell_hemisphere", "open hemisphere, pulled and pushed",
                [](int k) {
                    return open_hemisphere(std::array{12, 20, 27}[static_cast<std::size_t>(k)],
                                           std::array{12, 19, 27}[static_cast<std::size_t>(k)], GridCut::one_way);
                }),
            BenchCase{"shell_newton", "slit ring: iterations by the stress that the tangent is made with",
                      [](const BenchOptions& options) {
                          nlohmann::json rows = nlohmann::json::array();
                          for (const bool predict : {true, false}) {
                              rows.push_back(newton_row(slit_ring(30, 4), predict));
                              if (!options.quick) {
                                  rows.push_back(newton_row(slit_ring(62, 6), predict));
                              }
                          }
                          return rows;
                      }},
            one("shell_cylinder", "cylinder between diaphragms, pinched", [](int k) {
                const int n = std::array{27, 33, 38}[static_cast<std::size_t>(k)];
                return pinched_cylinder(n, n, GridCut::one_way);
            })};
}

}  // namespace rhexis::bench
