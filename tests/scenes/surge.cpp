// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/surge.hpp"

#include <algorithm>
#include <cmath>

#include "physics/fluid/chamber_flow.hpp"

namespace rhexis::scenes {
namespace {

constexpr double step = 0.01;  ///< [s]
constexpr int until_still = 1000;
constexpr int after_break = 400;

}  // namespace

ChamberControl aspirating(const MachineSetting& machine, double tip_open) {
    ChamberControl control;
    control.irrigation = true;
    control.bottle_height = 10.0 * machine.bottle_cm;
    control.pump_flow = machine.flow_ml_min * mm3_s_per_ml_min;
    control.vacuum_limit = machine.vacuum_mmhg * pascal_per_mmhg;
    control.tip_open = tip_open;
    return control;
}

Surge surge(const ChamberModel& model, const MachineSetting& machine) {
    Surge result;
    ChamberState state = chamber_state(model, 0.0, 0.0);
    const auto eye = [&] { return eye_pressure(model, state.eye_volume); };
    for (int i = 0; i < until_still; ++i) {
        advance_chamber(model, aspirating(machine, 1.0), step, state);
    }
    result.steady = eye();
    const double most_vacuum = 0.95 * machine.vacuum_mmhg * pascal_per_mmhg;
    for (int i = 1; i <= until_still; ++i) {
        advance_chamber(model, aspirating(machine, 0.0), step, state);
        if (result.rise == 0.0 && tube_pressure(model, state.tube_volume) <= -most_vacuum) {
            result.rise = i * step;
        }
    }
    result.held = result.lowest = eye();
    for (int i = 1; i <= after_break; ++i) {
        const ChamberFlows flows = advance_chamber(model, aspirating(machine, 1.0), step, state);
        result.lowest = std::min(result.lowest, flows.lowest_eye_pressure);
        if (std::abs(eye() - result.steady) > 0.05 * result.steady) {
            result.recovery = (i + 1) * step;
        }
    }
    const double least = eye_volume(model, result.lowest);
    result.lost = eye_volume(model, result.held) - least;
    result.below_steady = std::max(0.0, eye_volume(model, result.steady) - least);
    return result;
}

}  // namespace rhexis::scenes
