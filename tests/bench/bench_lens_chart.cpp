// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_lens_chart.hpp"
#include "bench/chart.hpp"

#include <cmath>
#include <map>

#include "bench/calculix.hpp"
#include "bench/chart.hpp"
#include "bench/lens_run.hpp"

namespace rhexis::bench {
namespace {

constexpr double total_load = 500.0;  // [uN]: small enough for the linear answer to hold within 1 %

nlohmann::json row(const std::string& series, const std::string& point, const scenes::LensPoke& poke,
                   const LensRun& run, double compliance, const LoadHistory& history) {
    nlohmann::json result = {{"name", series},
                             {"point", point},
                             {"elements", poke.lens.coarse.tets.size()},
                             {"nodes", poke.lens.coarse.nodes.size()},
                             {"cpu_s_per_s", run.cpu_s_per_s},
                             {"error_kind", "rms depth against C3D10 on the same mesh, over the final depth"}};
    if (run.depth.empty()) {
        result["failure"] = run.failure;
    } else {
        result["error"] = depth_error(run, compliance, total_load, history);
    }
    return result;
}

const char* name_of(Formulation formulation) {
    switch (formulation) {
        case Formulation::linear:
            return "linear";
        case Formulation::edge_smoothed:
            return "edge-smoothed";
        case Formulation::nodal_pressure:
            return "nodal pressure";
    }
    return "";
}

nlohmann::json run_chart(const BenchOptions& options) {
    const std::map<int, double> references = kept_compliances();
    const LoadHistory history;
    nlohmann::json rows = nlohmann::json::array();
    for (const auto& [size, compliance] : references) {
        if (options.quick && size > 1000) {
            break;
        }
        scenes::LensPoke poke = scenes::lens_poke(size, {.total = total_load});
        for (const Formulation formulation :
             {Formulation::linear, Formulation::edge_smoothed, Formulation::nodal_pressure}) {
            poke.lens.formulation = formulation;
            const std::string kind = name_of(formulation);
            for (const double share : {0.8, 0.4}) {
                if (formulation != Formulation::edge_smoothed) {
                    rows.push_back(row("explicit " + kind, share > 0.5 ? "0.8 of the limit" : "0.4 of the limit", poke,
                                       run_explicit(poke, share, history), compliance, history));
                }
            }
            if (formulation == Formulation::nodal_pressure) {
                continue;
            }
            for (const double step_s : {0.02, 0.01, 0.005, 0.002, 0.001}) {
                rows.push_back(row("implicit " + kind, milliseconds(step_s), poke,
                                   run_implicit(poke, step_s, 1, 1e-6, history), compliance, history));
            }
        }
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> lens_chart_cases() {
    return {{"lens_chart", "speed against accuracy of the ways to advance the lens, 1,000 to 24,000 tetrahedra",
             run_chart}};
}

}  // namespace rhexis::bench
