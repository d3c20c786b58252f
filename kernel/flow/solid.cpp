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

double tet_mass(const SolidModel& model, int t) {
    const std::size_t index = static_cast<std::size_t>(t);
    const std::array<int, 4>& tet = model.coarse.tets[index];
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < 4; ++k) {
        x[k] = model.coarse.nodes[static_cast<std::size_t>(tet[k])];
    }
    const Material& material = model.materials[static_cast<std::size_t>(model.coarse.region[index])];
    return material.density * tet_volume(x[0], x[1], x[2], x[3]);
}

double remaining_mass(const SolidModel& model, const SolidState& state) {
    double sum = 0.0;
    for (int t = 0; t < static_cast<int>(model.coarse.tets.size()); ++t) {
        sum += remaining_fraction(model, state, t) * tet_mass(model, t);
    }
    return sum;
}

}  // namespace rhexis
