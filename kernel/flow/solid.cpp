// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/solid.hpp"

#include <algorithm>

namespace rhexis {

SolidState rest_state(const SolidModel& model) {
    SolidState state;
    state.position = model.coarse.nodes;
    state.velocity.assign(model.coarse.nodes.size(), Vec3::Zero());
    state.fraction.assign(model.fine.tets.size(), 1.0);
    state.present.assign(model.coarse.tets.size(), 1);
    return state;
}

namespace {

auto place_in(auto& spent, int fine) {
    return std::lower_bound(spent.begin(), spent.end(), fine,
                            [](const PartlySpent& one, int wanted) { return one.fine < wanted; });
}

}  // namespace

std::array<double, 4> left_of_points(const SolidState& state, int fine) {
    const auto found = place_in(state.spent, fine);
    if (found != state.spent.end() && found->fine == fine) {
        return found->left;
    }
    const double fraction = state.fraction[static_cast<std::size_t>(fine)];
    return {fraction, fraction, fraction, fraction};
}

void set_fraction(SolidState& state, int fine, double fraction) {
    double& now = state.fraction[static_cast<std::size_t>(fine)];
    const auto found = place_in(state.spent, fine);
    if (found != state.spent.end() && found->fine == fine) {
        if (!(fraction > 0.0)) {
            state.spent.erase(found);
        } else {
            for (double& left : found->left) {
                left = std::min(1.0, left * (fraction / now));
            }
        }
    }
    now = fraction;
}

void set_points(SolidState& state, int fine, const std::array<double, 4>& left) {
    const double fraction = 0.25 * (left[0] + left[1] + left[2] + left[3]);
    const auto found = place_in(state.spent, fine);
    const bool there = found != state.spent.end() && found->fine == fine;
    if (!(fraction > 0.0)) {
        state.spent.erase(found, there ? found + 1 : found);
    } else if (there) {
        found->left = left;
    } else {
        state.spent.insert(found, {fine, left});
    }
    state.fraction[static_cast<std::size_t>(fine)] = fraction;
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
