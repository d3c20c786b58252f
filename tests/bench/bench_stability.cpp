// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_stability.hpp"

#include <cmath>

#include "scenes/bodies.hpp"
#include "scenes/explicit_trials.hpp"

namespace rhexis::bench {
namespace {

nlohmann::json row(const std::string& name, const SolidModel& model, double error, const std::string& kind,
                   bool passed) {
    return {{"name", "stability/" + name},
            {"elements", model.coarse.tets.size()},
            {"nodes", model.coarse.nodes.size()},
            {"error", error},
            {"error_kind", kind},
            {"passed", passed}};
}

void recoveries(const BenchOptions& options, nlohmann::json& rows) {
    const SolidModel lens = scenes::default_eye(options.quick ? 1000 : 3000).lens;
    const std::vector<std::pair<std::string, scenes::BadStart>> starts{{"random", scenes::BadStart::random},
                                                                       {"flat", scenes::BadStart::flat},
                                                                       {"mirrored", scenes::BadStart::mirrored}};
    for (const auto& [name, start] : starts) {
        const scenes::Recovery r = scenes::recover(lens, start, options.quick ? 1.0 : 2.0);
        rows.push_back(row("T1_" + name, lens, r.inverted_at_end, "share of inverted elements left",
                           r.finite && r.inverted_at_end == 0.0 && r.largest_rise < 1e-6));
        rows.back()["energy_left"] = r.energy_left;
        rows.back()["largest_energy_rise"] = r.largest_rise;
    }
}

void limits(nlohmann::json& rows) {
    for (const double nu : {0.3, 0.45, 0.47, 0.49, 0.499}) {
        for (const double sliver : {1.0, 0.05, 0.01}) {
            if (nu > 0.49 && sliver < 0.05) {
                continue;  // steps of 0.1 us and strains of 1e-4 by rounding alone: no body to be stepped in float
            }
            SolidModel model = scenes::cube(4, 2.0, 5000.0, nu);
            scenes::flatten_one(model, sliver);
            const scenes::Limit limit = scenes::probe_limit(model);
            const std::string id = (sliver < 1.0 ? "T4" : "T3");
            rows.push_back(row(id + "_nu_" + nlohmann::json(nu).dump() + "_sliver_" + nlohmann::json(sliver).dump(),
                               model, 0.0, "bounded at 0.97 of the stable step, not at 1.1",
                               limit.below && limit.beyond));
            rows.back()["stable_step_us"] = 1e6 * limit.step;
        }
    }
}

void deletions(const BenchOptions& options, nlohmann::json& rows) {
    const SolidModel lens = scenes::default_eye(options.quick ? 1000 : 3000).lens;
    const scenes::Deletion d = scenes::delete_all(lens, 5, options.quick ? 20 : 100);
    rows.push_back(row("T17", lens, d.mass_error, "mass removed + left, relative", d.finite && d.mass_error < 1e-12));
    rows.back()["steps"] = d.steps;
    rows.back()["fastest_mm_s"] = d.fastest;
    rows.back()["smallest_stable_step_ratio"] = d.smallest_step;
}

void flights(const BenchOptions& options, nlohmann::json& rows) {
    const SolidModel model = scenes::cube(3, 2.0, 3000.0, 0.45);
    const int steps = options.quick ? 50000 : 1000000;
    for (const double share : {0.5, 0.8}) {
        const scenes::Flight f = scenes::fly(model, steps, share);
        const std::string at = "_at_" + nlohmann::json(share).dump();
        rows.push_back(row("T20" + at, model, std::max(f.linear_drift, f.angular_drift),
                           "momentum drift per step, relative", std::max(f.linear_drift, f.angular_drift) < 2e-8));
        rows.push_back(row("T21" + at, model, f.energy_drift, "energy drift over all steps, relative, undamped",
                           std::abs(f.energy_drift) < 0.05));
        rows.back()["steps"] = steps;
    }
}

nlohmann::json run_stability(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    recoveries(options, rows);
    limits(rows);
    deletions(options, rows);
    flights(options, rows);
    return rows;
}

}  // namespace

std::vector<BenchCase> stability_cases() {
    return {{"stability", "explicit solids provoked: bad starts, slivers, deletion to the last, long free flight",
             run_stability}};
}

}  // namespace rhexis::bench
