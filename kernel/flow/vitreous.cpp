// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/vitreous.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "math/roots.hpp"

namespace rhexis {

VitreousState rest_state(const VitreousModel& model, const ChamberModel& chamber) {
    VitreousState state;
    state.broken = !(model.hyaloid_strength > 0.0);
    state.behind = chamber.rest_pressure + model.push;
    state.front[capsule_hole] = model.start_front;
    state.wound = model.start_wound;
    state.marked = model.start_marked;
    state.filled = model.start_fill * model.chamber_volume;
    return state;
}

double vitreous_in_front(const VitreousState& state) {
    return std::accumulate(state.front.begin(), state.front.end(), 0.0);
}

double vitreous_radius(double volume) { return cube_root(std::max(0.0, volume) * 0.75 / std::numbers::pi); }

double filled_share(const VitreousModel& model, const VitreousState& state) {
    const double plugs = std::accumulate(state.plug.begin(), state.plug.end(), 0.0);
    return std::clamp((state.filled + plugs) / model.chamber_volume, 0.0, 1.0);
}

double covered_share(const VitreousModel& model, double plug, double area) {
    if (!(area > 0.0)) {
        return 1.0;
    }
    const double radius = std::sqrt(area / std::numbers::pi) + model.margin;
    return std::clamp(plug / (std::numbers::pi * radius * radius * model.mound), 0.0, 1.0);
}

}  // namespace rhexis
