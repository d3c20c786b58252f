// SPDX-License-Identifier: GPL-3.0-or-later
// What a split costs the solver: the factor made anew, kept and changed, or left as it was. One simulation is recorded;
// its linear systems are given to every method in turn.
#include "bench/bench_factor_update.hpp"

#include <algorithm>
#include <array>

#include "base/clock.hpp"
#include "bench/methods/kernel_factor.hpp"
#include "bench/methods/split_solver.hpp"
#include "physics/membrane/tear_tip.hpp"
#include "scenes/split_run.hpp"

namespace rhexis::bench {
namespace {

constexpr double tolerance = 1e-9;
constexpr double lively = 50.0;    // share of the mass that damps, as of bench tear_split [1/s]
constexpr double damped = 2000.0;  // forty times as much

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

/// States just after each split.
struct Recording {
    std::unique_ptr<scenes::SplitRun> run;
    std::vector<MembraneState> states;
    double step_s = 0.0;  ///< CPU time of a whole step with its split, median [s]
};

Recording record(int triangles, double damping, int splits) {
    Recording recording;
    recording.run = std::make_unique<scenes::SplitRun>(triangles, damping);
    std::vector<double> seconds;
    while (static_cast<int>(recording.states.size()) < splits) {
        const double start = thread_cpu_seconds();
        const bool split = recording.run->split();
        double used = thread_cpu_seconds() - start;
        if (split) {
            recording.states.push_back(recording.run->state());
        }
        const double again = thread_cpu_seconds();
        recording.run->step();
        propose_tears(recording.run->model(), recording.run->state());
        used += thread_cpu_seconds() - again;
        if (split) {
            seconds.push_back(used);
        }
    }
    recording.step_s = median(seconds);
    return recording;
}

/// The same splits of a sheet that stays where it is, so that the splits alone change the matrix: the bound of what
/// following them can save.
void hold_still(std::vector<MembraneState>& states) {
    for (MembraneState& state : states) {
        for (std::size_t i = 0; i < state.position.size(); ++i) {
            state.position[i] = 1.03 * state.sheet->mesh.nodes[i];
            state.velocity[i] = Vec3::Zero();
        }
    }
}

/// Triangles whose share of the matrix changes by more than half from one split to the next, though the splits leave
/// them alone; mean.
double triangles_changed_by_motion(const MembraneModel& model, const std::vector<MembraneState>& states) {
    double changed = 0.0;
    for (std::size_t i = 1; i < states.size(); ++i) {
        const std::vector<std::array<int, 3>>& before = states[i - 1].sheet->mesh.triangles;
        const std::vector<std::array<int, 3>>& now = states[i].sheet->mesh.triangles;
        for (std::size_t t = 0; t < before.size(); ++t) {
            if (before[t] == now[t]) {
                const Mat9 was = triangle_share(model, states[i - 1], static_cast<int>(t), scenes::SplitRun::step_s);
                const Mat9 is = triangle_share(model, states[i], static_cast<int>(t), scenes::SplitRun::step_s);
                changed += (is - was).norm() > 0.5 * was.norm() ? 1.0 : 0.0;
            }
        }
    }
    return changed / static_cast<double>(states.size() - 1);
}

/// Thread CPU time of what the kernel does for a new sheet before it can solve; medians over the splits [s].
struct FactorParts {
    double body_s = 0.0;      ///< rows, pattern and triangles of the sheet
    double analysis_s = 0.0;  ///< panels of the factor and where they go
    double assembly_s = 0.0;  ///< forces, stiffness and right side
    double numbers_s = 0.0;   ///< the factor itself
};

FactorParts parts_of_default(const MembraneModel& model, const std::vector<MembraneState>& states) {
    MembraneBody body(model, model.sheet);
    FactorPreconditioner factor(body.pattern(), *linear_kernel::choose());
    std::array<std::vector<double>, 4> parts;
    for (const MembraneState& state : states) {
        std::array<double, 5> clock{thread_cpu_seconds()};
        const std::vector<int> row_now = body.follow(state.sheet, true);
        clock[1] = thread_cpu_seconds();
        factor.follow(body.pattern(), row_now);
        clock[2] = thread_cpu_seconds();
        const SplitSystem system = assemble(model, state, body, scenes::SplitRun::step_s);
        clock[3] = thread_cpu_seconds();
        factor.factor(system.matrix, FactorPreconditioner::Precision::single);
        clock[4] = thread_cpu_seconds();
        for (std::size_t k = 0; k < 4; ++k) {
            parts[k].push_back(clock[k + 1] - clock[k]);
        }
    }
    return {median(parts[0]), median(parts[1]), median(parts[2]), median(parts[3])};
}

struct Entrant {
    SplitMethod method;
    int splits;                                 ///< per factor
    std::vector<std::vector<double>> factor_s;  ///< per split, of every repeat
    std::vector<std::vector<double>> solve_s;
    double iterations = 0.0;  ///< sums over a repeat
    double entries = 0.0;
    int factored = 0;
    double residual = 0.0;  ///< largest, relative
};

std::vector<Entrant> entrants(std::size_t splits) {
    std::vector<Entrant> result;
    const auto add = [&](SplitMethod method, const std::vector<int>& per_factor) {
        for (const int each : per_factor) {
            result.push_back(
                {method, each, std::vector<std::vector<double>>(splits), std::vector<std::vector<double>>(splits)});
        }
    };
    add(SplitMethod::anew, {1});
    add(SplitMethod::anew_double, {1});
    add(SplitMethod::stale, {1, 2, 3, 5, 10});
    add(SplitMethod::updown, {1, 2, 5, 10, 20});
    add(SplitMethod::woodbury, {2, 3, 5, 10, 20});
    return result;
}

void replay_once(const MembraneModel& model, const std::vector<MembraneState>& states, std::vector<Entrant>& all) {
    std::vector<std::unique_ptr<SplitSolver>> solvers;
    for (Entrant& one : all) {
        solvers.push_back(split_solver(one.method, one.splits));
        one.iterations = one.entries = 0.0;
        one.factored = 0;
    }
    MembraneBody body(model, model.sheet);
    std::vector<double> x;
    for (std::size_t i = 0; i < states.size(); ++i) {
        body.follow(states[i].sheet, true);
        const SplitSystem system = assemble(model, states[i], body, scenes::SplitRun::step_s);
        for (std::size_t k = 0; k < all.size(); ++k) {
            const SplitSolver::Report report = solvers[k]->solve(system, tolerance, x);
            Entrant& one = all[k];
            one.factor_s[i].push_back(report.factor_s);
            one.solve_s[i].push_back(report.solve_s);
            one.iterations += report.iterations;
            one.entries += static_cast<double>(report.entries);
            one.factored += report.factored ? 1 : 0;
            one.residual = std::max(one.residual, true_residual(system, x));
        }
    }
}

/// CPU times of a split are medians over the repeats; factors are not made at every split, so those are averaged.
nlohmann::json row_of(const Entrant& one, const std::string& scene) {
    const double splits = static_cast<double>(one.factor_s.size());
    double factor = 0.0;
    double solve = 0.0;
    double slowest = 0.0;
    for (std::size_t i = 0; i < one.factor_s.size(); ++i) {
        const double own_factor = median(one.factor_s[i]);
        const double own_solve = median(one.solve_s[i]);
        factor += own_factor / splits;
        solve += own_solve / splits;
        slowest = std::max(slowest, own_factor + own_solve);
    }
    return {{"name", "factor_update/" + scene + "/" + name_of(one.method) + "/" + std::to_string(one.splits)},
            {"method", name_of(one.method)},
            {"scene", scene},
            {"splits_per_factor", one.splits},
            {"cpu_ms", 1e3 * (factor + solve)},
            {"factor_ms", 1e3 * factor},
            {"solve_ms", 1e3 * solve},
            {"slowest_ms", 1e3 * slowest},
            {"iterations", one.iterations / splits},
            {"refactored", one.factored / splits},
            {"entries", one.entries / splits},
            {"error", one.residual},
            {"error_kind", "largest relative residual of a system"}};
}

void replay(const MembraneModel& model, const std::vector<MembraneState>& states, const std::string& scene, int repeats,
            nlohmann::json& rows) {
    std::vector<Entrant> all = entrants(states.size());
    for (int repeat = 0; repeat < repeats; ++repeat) {
        replay_once(model, states, all);
    }
    double kept = 0.0;
    const std::size_t first = rows.size();
    for (const Entrant& one : all) {
        rows.push_back(row_of(one, scene));
        rows.back()["elements"] = model.sheet->mesh.triangles.size();
        if (one.method == SplitMethod::stale && one.splits == 1) {
            kept = rows.back()["cpu_ms"];
        }
    }
    for (std::size_t i = first; i < rows.size(); ++i) {
        rows[i]["ratio"] = rows[i]["cpu_ms"].get<double>() / kept;
    }
}

nlohmann::json step_row(const Recording& recording, const std::string& scene) {
    const MembraneModel& model = recording.run->model();
    const FactorParts parts = parts_of_default(model, recording.states);
    return {{"name", "factor_update/" + scene + "/step"},
            {"method", "whole step"},
            {"scene", scene},
            {"elements", model.sheet->mesh.triangles.size()},
            {"elements_at_the_end", recording.states.back().sheet->mesh.triangles.size()},
            {"changed_by_motion", triangles_changed_by_motion(model, recording.states)},
            {"body_ms", 1e3 * parts.body_s},
            {"analysis_ms", 1e3 * parts.analysis_s},
            {"assembly_ms", 1e3 * parts.assembly_s},
            {"numbers_ms", 1e3 * parts.numbers_s},
            {"cpu_ms", 1e3 * recording.step_s}};
}

nlohmann::json run(int triangles, const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const int repeats = options.quick || triangles > 3000 ? 1 : std::min(options.repeats, 3);
    const int splits = options.quick ? 10 : 200;
    const auto scene = [&](const Recording& recording, const std::string& name) {
        const std::string full = std::to_string(triangles) + "/" + name;
        rows.push_back(step_row(recording, full));
        replay(recording.run->model(), recording.states, full, repeats, rows);
    };
    const int size = options.quick ? 400 : triangles;
    Recording recording = record(size, lively, splits);
    scene(recording, "lively");
    scene(record(size, damped, splits), "damped");
    hold_still(recording.states);
    scene(recording, "still");
    return rows;
}

}  // namespace

std::vector<BenchCase> factor_update_cases() {
    const auto of = [](int triangles) {
        return [triangles](const BenchOptions& options) { return run(triangles, options); };
    };
    return {{"factor_update", "solves of 1,500 triangles with a split in every step, by what becomes of the factor",
             of(1500)},
            {"factor_update_6000", "the same of 6,000 triangles", of(6000)}};
}

}  // namespace rhexis::bench
