// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/world.hpp"

namespace rhexis {

WorldState rest_state(const WorldModel& model) {
    WorldState state;
    for (const SolidModel& solid : model.solids) {
        state.solids.push_back(rest_state(solid));
    }
    state.bags.resize(model.bags.size());
    return state;
}

}  // namespace rhexis
