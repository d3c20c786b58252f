// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/hydrodissection.hpp"

#include <algorithm>
#include <numeric>

#include "math/turn.hpp"

namespace rhexis {

namespace {

constexpr double widening = 0.06;  ///< of the pupil per mm that the lens comes forward. Proposal
constexpr double snap = 0.25;      ///< of the pupil when the capsule bursts: 20 to 30 % [Yeoh1996]
constexpr double snap_s = 0.2;     ///< time that it takes [s]. Proposal

}  // namespace

HydrodissectionState rest_state(const HydrodissectionModel& model) {
    HydrodissectionState state;
    for (int cell = 0; cell < cell_count(model.cells); ++cell) {
        const Vec2 middle = cell_middle(model.cells, cell);
        const bool free = share_of_turn(Vec3(middle.x(), middle.y(), 0.0)) < model.start_cleaved;
        state.cleaved.push_back(free ? 1.0 : 0.0);
    }
    state.filled = model.start_fill * model.chamber_volume;
    return state;
}

double wave_share(const HydrodissectionState& state) {
    return std::accumulate(state.cleaved.begin(), state.cleaved.end(), 0.0) /
           static_cast<double>(std::max<std::size_t>(1, state.cleaved.size()));
}

double viscoelastic_fill(const HydrodissectionModel& model, const HydrodissectionState& state) {
    return state.filled / model.chamber_volume;
}

double forward_shift(const HydrodissectionModel& model, const HydrodissectionState& state) {
    return state.trapped / model.lens_area;
}

double pupil_share(const HydrodissectionModel& model, const HydrodissectionState& state) {
    if (state.burst_s >= 0.0) {
        return 1.0 - snap * std::min(1.0, state.burst_s / snap_s);
    }
    return 1.0 + widening * forward_shift(model, state);
}

double sinking_force(const HydrodissectionModel& model, const HydrodissectionState& state) {
    return state.burst_s >= 0.0 ? model.sink * std::max(0.0, 1.0 - state.lifted / model.lifts) : 0.0;
}

}  // namespace rhexis
