// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/solid.hpp"

namespace rhexis {

SolidState rest_state(const SolidModel& model) {
    SolidState state;
    state.position = model.coarse.nodes;
    state.velocity.assign(model.coarse.nodes.size(), Vec3::Zero());
    state.fraction.assign(model.fine.tets.size(), 1.0);
    state.present.assign(model.coarse.tets.size(), 1);
    return state;
}

double remaining_fraction(const SolidModel& model, const SolidState& state, int t) {
    if (model.fine.tets.empty()) {
        return static_cast<double>(state.present[static_cast<std::size_t>(t)]);
    }
    const std::size_t first = 8 * static_cast<std::size_t>(t);
    double sum = 0.0;
    for (std::size_t child = first; child < first + 8; ++child) {
        sum += state.fraction[child];
    }
    return sum / 8.0;
}

}  // namespace rhexis
