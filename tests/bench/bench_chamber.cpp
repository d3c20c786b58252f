// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_chamber.hpp"

#include "bench/timing.hpp"
#include "physics/fluid/chamber_flow.hpp"
#include "scenes/surge.hpp"

namespace rhexis::bench {
namespace {

nlohmann::json surge_row(const scenes::MachineSetting& machine, double tube_mm3_mmhg) {
    ChamberModel model;
    model.tube_compliance = tube_mm3_mmhg / pascal_per_mmhg;
    const scenes::Surge found = scenes::surge(model, machine);
    char name[96];
    std::snprintf(name, sizeof name, "surge/%g cm/%g ml_min/%g mmHg/%.2f", machine.bottle_cm, machine.flow_ml_min,
                  machine.vacuum_mmhg, tube_mm3_mmhg);
    return {{"name", name},
            {"steady_mmhg", found.steady / pascal_per_mmhg},
            {"occluded_mmhg", found.held / pascal_per_mmhg},
            {"lowest_mmhg", found.lowest / pascal_per_mmhg},
            {"lost_mm3", found.lost},
            {"below_steady_mm3", found.below_steady},
            {"rise_s", found.rise},
            {"recovery_s", found.recovery}};
}

nlohmann::json run_chamber(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    rows.push_back(surge_row({80.0, 20.0, 400.0}, 0.15));
    rows.push_back(surge_row({100.0, 40.0, 400.0}, 0.15));
    for (const double tubing : {0.15, 0.30, 0.60}) {
        rows.push_back(surge_row({90.0, 30.0, 600.0}, tubing));
    }
    for (const double bottle : {60.0, 90.0, 110.0}) {
        rows.push_back(surge_row({bottle, 30.0, 400.0}, 0.15));
    }
    rows.push_back(surge_row({90.0, 30.0, 200.0}, 0.15));
    const ChamberModel model;
    const ChamberControl control = scenes::aspirating({}, 1.0);
    ChamberState state = chamber_state(model, 0.0, 0.0);
    const Timing timing = time_interleaved({[&] { advance_chamber(model, control, 0.01, state); }}, options.repeats)[0];
    rows.push_back({{"name", "step of 10 ms"}, {"us", 1e6 * timing.seconds}, {"spread", timing.spread}});
    return rows;
}

}  // namespace

std::vector<BenchCase> chamber_cases() {
    return {{"chamber", "what the eye feels when an occlusion breaks, by bottle, vacuum and tubing", run_chamber}};
}

}  // namespace rhexis::bench
