// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "bench/calculix.hpp"
#include "bench/charts/models.hpp"
#include "bench/lens_run.hpp"

namespace rhexis::bench {
namespace {

constexpr double poke_load = 500.0;  ///< [uN]: small enough for the linear answer to hold within 1 %
constexpr int usual_size = 1000;     ///< of exercises in which nothing ploughs through the lens (docs/accuracy.md)
constexpr int largest_size = 6000;

struct Way {
    const char* name;
    Formulation formulation;
    bool implicit;
    bool usual = false;
};

std::vector<ChartPoint> measure_lens(const ChartOptions& options) {
    const std::vector<Way> ways{
        {"explicit, pressure at nodes (kernel, where tools are)", Formulation::nodal_pressure, false, true},
        {"implicit, edge-smoothed (kernel, else)", Formulation::edge_smoothed, true},
        {"explicit, linear", Formulation::linear, false},
        {"implicit, linear [Dequidt2013]", Formulation::linear, true}};
    const LoadHistory history;
    std::vector<ChartPoint> points;
    for (const Way& way : ways) {
        for (const auto& [size, compliance] : kept_compliances()) {
            const bool is_default = way.usual && size == usual_size;
            if (size > largest_size || (options.only_default && !is_default)) {
                continue;
            }
            scenes::LensPoke poke = scenes::lens_poke(size, {.total = poke_load});
            poke.lens.formulation = way.formulation;
            const LensRun run =
                way.implicit ? run_implicit(poke, 0.01, 1, 1e-6, history) : run_explicit(poke, 0.8, history);
            ChartPoint point = point_of(way.name, std::to_string(poke.lens.coarse.tets.size()) + " tetrahedra",
                                        is_default, 0.0, run.cpu_s_per_s);
            point.failure = run.failure;
            point.error = run.depth.empty() ? 0.0 : depth_error(run, compliance, poke_load, history);
            points.push_back(point);
        }
    }
    return points;
}

}  // namespace

Chart chart_lens() {
    return {"lens",
            "A lens, held behind, poked by 0.5 mN within 0.3 s",
            cpu_per_second,
            "depth over time, rms, as a share of the last",
            "quadratic tetrahedra (C3D10) of CalculiX on the same mesh",
            true,
            measure_lens};
}

}  // namespace rhexis::bench
