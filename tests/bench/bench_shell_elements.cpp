// SPDX-License-Identifier: GPL-3.0-or-later
// Two plates in the same shell: the discrete Kirchhoff triangle and the nine-term polynomial of [Dequidt2013]. Error
// against triangles and against the time of a Newton iteration.
#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "bench/bench_shell.hpp"
#include "bench/methods/nine_term_plate.hpp"
#include "physics/shell/shell_statics.hpp"
#include "scenes/shell_problems.hpp"

namespace rhexis::bench {
namespace {

using scenes::GridCut;
using scenes::ShellProblem;

struct Element {
    const char* name;
    ShellTriangleMaker maker;
};
constexpr Element elements[] = {{"dkt", shell_triangle}, {"nine_term", nine_term_triangle}};

/// Error of the second measure at the last row of the reference, the first where there is no second.
nlohmann::json row(const std::string& name, const ShellProblem& problem, const Element& element, int repeats) {
    const ShellProblem::Row& last = problem.reference.back();
    double fastest = HUGE_VAL;
    double value = 0.0;
    bool converged = true;
    for (int k = 0; k < repeats; ++k) {
        ShellStatics statics = std::move(ShellStatics::create(problem.model, element.maker)).value();
        ShellState state = rest_state(problem.model);
        int iterations = 0;
        double factor = 0.0;
        const double start = thread_cpu_seconds();
        for (const ShellProblem::Row& one : problem.reference) {
            const ShellStaticReport report = statics.load_to(problem.load, factor, one.factor, {}, state);
            iterations += report.iterations;
            converged = converged && report.converged;
            factor = one.factor;
        }
        fastest = std::min(fastest, (thread_cpu_seconds() - start) / std::max(iterations, 1));
        value = problem.measure(state)[1];
    }
    return {{"problem", name},
            {"element", element.name},
            {"elements", problem.model.mesh.triangles.size()},
            {"value", value},
            {"reference", last.measure[1]},
            {"signed_error", converged ? value / last.measure[1] - 1.0 : HUGE_VAL},
            {"cpu_ms", 1e3 * fastest},
            {"error", converged ? std::abs(value / last.measure[1] - 1.0) : HUGE_VAL},
            {"error_kind", "relative, of the deflection at full load"}};
}

std::vector<ShellProblem> meshes(const std::string& name) {
    std::vector<ShellProblem> result;
    for (const int k : {0, 1, 2, 3}) {
        const std::size_t i = static_cast<std::size_t>(k);
        if (name == "plate") {
            result.push_back(scenes::clamped_plate(8 * (1 << k)));
        } else if (name == "cantilever") {
            result.push_back(scenes::cantilever_shear(8 << k, 1 << k));
        } else if (name == "ring") {
            result.push_back(scenes::slit_ring(std::array{30, 42, 62, 90}[i], std::array{4, 4, 6, 10}[i]));
        } else {
            const int n = std::array{8, 12, 20, 27}[i];
            result.push_back(scenes::open_hemisphere(n, n == 20 ? 19 : n, GridCut::one_way));
        }
    }
    return result;
}

}  // namespace

std::vector<BenchCase> shell_element_cases() {
    return {{"shell_elements",
             "plate of the shell: discrete Kirchhoff against nine-term, error against triangles and time",
             [](const BenchOptions& options) {
                 nlohmann::json rows = nlohmann::json::array();
                 for (const char* name : {"plate", "cantilever", "ring", "hemisphere"}) {
                     std::vector<ShellProblem> problems = meshes(name);
                     problems.resize(options.quick ? 1 : problems.size());
                     for (const Element& element : elements) {
                         for (const ShellProblem& problem : problems) {
                             rows.push_back(row(name, problem, element, options.quick ? 1 : 3));
                         }
                     }
                 }
                 return rows;
             }}};
}

}  // namespace rhexis::bench
