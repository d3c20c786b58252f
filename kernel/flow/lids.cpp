// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/lids.hpp"

#include <algorithm>

namespace rhexis {
namespace {

/// To the surgeon's right, half a spacing from the corners at least [mm].
double across(const LidsModel& model, int place) {
    const int along = place % model.per_lid;
    return model.half_width * ((2.0 * along + 1.0) / model.per_lid - 1.0);
}

double half_height(const LidsModel& model, double opening) {
    return model.shut + std::clamp(opening, 0.0, 1.0) * (model.opened - model.shut);
}

}  // namespace

LidsState rest_state(const LidsModel& model) {
    LidsState state;
    state.covered.assign(static_cast<std::size_t>(2 * model.per_lid), 0);
    return state;
}

Vec3 lash_place(const LidsModel& model, double opening, int place) {
    const double x = across(model, place);
    const double share = x / model.half_width;
    const double side = place < model.per_lid ? -1.0 : 1.0;
    return {x, side * half_height(model, opening) * (1.0 - share * share), model.height - model.fall * x * x};
}

Vec2 lash_way(const LidsModel& model, double opening, int place) {
    const double side = place < model.per_lid ? -1.0 : 1.0;
    const double slope =
        2.0 * half_height(model, opening) * across(model, place) / (model.half_width * model.half_width);
    return Vec2(slope, side).normalized();
}

double covered_share(const LidsState& state) {
    if (state.covered.empty()) {
        return 1.0;
    }
    const auto covered = std::count(state.covered.begin(), state.covered.end(), std::uint8_t{1});
    return static_cast<double>(covered) / static_cast<double>(state.covered.size());
}

}  // namespace rhexis
