// SPDX-License-Identifier: GPL-3.0-or-later
// Every committed step of an implant and of a capsule, verified: did anything go through anything, and how deep.
#include <functional>

#include "bench/bench_shell.hpp"
#include "scenes/verified_runs.hpp"

namespace rhexis::bench {
namespace {

nlohmann::json row(const scenes::VerifiedRun& run) {
    const double steps = run.steps;
    nlohmann::json result{{"name", "verify/" + run.name},
                          {"elements", run.triangles},
                          {"steps", run.steps},
                          {"pierced_at_start", run.pierced_at_start},
                          {"crossing_pairs", run.worst.crossing},
                          {"first_crossing", run.first_crossing},
                          {"worst_step", run.worst_step},
                          {"deepest_mm", run.worst.deepest},
                          {"deepest_of_edge", run.worst.of_edge},
                          {"pairs_a_step", static_cast<double>(run.worst.pairs) / steps},
                          {"cpu_ms_a_step", 1e3 * run.cpu_s / steps},
                          {"error", run.worst.of_thickness},
                          {"error_kind", "deepest penetration over thickness"}};
    nlohmann::json shares;
    for (std::size_t i = 0; i < scenes::depths_tried.size(); ++i) {
        shares.push_back({{"depth", scenes::depths_tried[i]}, {"steps", run.free_to[i] / steps}});
    }
    result["proven_free_to"] = shares;
    return result;
}

BenchCase named(const char* name, const char* summary,
                std::function<std::vector<scenes::VerifiedRun>(const BenchOptions&)> runs) {
    return {name, summary, [runs = std::move(runs)](const BenchOptions& options) {
                nlohmann::json rows = nlohmann::json::array();
                for (const scenes::VerifiedRun& run : runs(options)) {
                    rows.push_back(row(run));
                }
                return rows;
            }};
}

}  // namespace

std::vector<BenchCase> verify_cases() {
    return {named("verify_injection", "steps of an injected implant that are proven free of penetration, by depth",
                  [](const BenchOptions& options) {
                      return scenes::verify_injection(
                          {.triangles = options.quick ? 400.0 : 743.0, .tucked = !options.quick, .unfolding = 2.0});
                  }),
            named("verify_bag", "the same of an implant pushed into its bag, and of the bag",
                  [](const BenchOptions& options) {
                      return scenes::verify_bag_injection(400.0, 800.0, options.quick ? 1.0 : 6.0);
                  }),
            named("verify_tear", "the same of a capsule that is torn round",
                  [](const BenchOptions& options) { return scenes::verify_tear(1500, options.quick ? 0.4 : 2.2); })};
}

}  // namespace rhexis::bench
