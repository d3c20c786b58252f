// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/beads.hpp"

#include <algorithm>

namespace rhexis {

BeadsState rest_state(const BeadsModel& model) {
    BeadsState state;
    for (const Vec3& place : model.start) {
        state.beads.push_back({place, Vec3::Zero(), -1});
    }
    return state;
}

bool over_tray(const BeadsModel& model, const Vec3& place) {
    return (place - model.target).head<2>().norm() <= model.target_radius;
}

int placed_beads(const BeadsModel& model, const BeadsState& state) {
    return static_cast<int>(std::count_if(state.beads.begin(), state.beads.end(), [&](const Bead& bead) {
        return bead.tool < 0 && bead.position.z() <= model.floor && over_tray(model, bead.position);
    }));
}

}  // namespace rhexis
