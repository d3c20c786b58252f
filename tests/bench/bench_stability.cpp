// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_stability.hpp"

#include "scenes/stability_gates.hpp"

namespace rhexis::bench {
namespace {

nlohmann::json run_stability(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    for (const scenes::GateGroup& group : scenes::stability_gates()) {
        for (const scenes::Gate& gate : group.run(options.quick)) {
            rows.push_back({{"name", "stability/" + gate.id},
                            {"group", group.id},
                            {"provoked", group.what},
                            {"why", group.why},
                            {"what", gate.what},
                            {"measured", gate.measured},
                            {"gate", gate.limit},
                            {"passed", gate.passed()}});
        }
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> stability_cases() {
    return {{"stability", "gates of both ways to advance, provoked: bad starts, blows, slopes, deletion, long flights",
             run_stability}};
}

}  // namespace rhexis::bench
