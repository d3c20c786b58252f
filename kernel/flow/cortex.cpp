// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/cortex.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

namespace {

constexpr double none_left = 0.05;  ///< share of a cell's volume that covers nothing any more. Proposal

}  // namespace

CortexState rest_state(const CortexModel& model) {
    CortexState state;
    const int with = static_cast<int>(std::lround(model.start_left * model.cells.sectors));
    for (int cell = 0; cell < cell_count(model.cells); ++cell) {
        const bool left = cell / model.cells.rings < with;
        state.volume.push_back(left ? model.volume : 0.0);
        state.attached.push_back(left ? 1.0 : 0.0);
    }
    return state;
}

Vec3 cortex_place(const CortexModel& model, const BagShape& bag, int cell) {
    const Vec2 middle = cell_middle(model.cells, cell);
    const double share = middle.squaredNorm() / (bag.radius * bag.radius);
    const double depth = bag.posterior * std::sqrt(std::max(0.0, 1.0 - share));
    const bool fornix = cell % model.cells.rings == model.cells.rings - 1;
    return {middle.x(), middle.y(), fornix ? 0.0 : -depth};
}

double cortex_left(const CortexModel& model, const CortexState& state) {
    const auto covers = [&](double volume) { return volume > none_left * model.volume; };
    return static_cast<double>(std::count_if(state.volume.begin(), state.volume.end(), covers)) /
           static_cast<double>(std::max<std::size_t>(1, state.volume.size()));
}

}  // namespace rhexis
