// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/crumble.hpp"

#include "topology/remove.hpp"

namespace rhexis {

namespace {

/// What is left of one piece, summed.
struct Left {
    double volume = 0.0;
    double mass = 0.0;
    double energy = 0.0;  ///< to emulsify it [mJ]
    Vec3 moment = Vec3::Zero();
    Vec3 momentum = Vec3::Zero();
    std::vector<int> tets;
};

void add(const SolidModel& model, const SolidState& state, int t, Left& left) {
    const std::array<int, 4>& tet = model.coarse.tets[t];
    const Material& material = model.materials[model.coarse.region[t]];
    const double mass = tet_mass(model, t) * remaining_fraction(model, state, t);
    for (const int node : tet) {
        left.moment += 0.25 * mass * state.position[node];
        left.momentum += 0.25 * mass * state.velocity[node];
    }
    left.mass += mass;
    left.volume += mass / material.density;
    left.energy += mass / material.density * material.ablation_energy;
    left.tets.push_back(t);
}

}  // namespace

Crumbs crumble(const SolidModel& model, const SolidState& state, int solid, const std::vector<int>& pieces,
               double below) {
    std::vector<Left> left(pieces.size());
    for (std::size_t t = 0; t < pieces.size(); ++t) {
        if (pieces[t] >= 0) {
            add(model, state, static_cast<int>(t), left[pieces[t]]);
        }
    }
    Crumbs crumbs;
    std::vector<int> gone;
    for (const Left& piece : left) {
        if (piece.tets.empty() || piece.volume >= below) {
            continue;
        }
        gone.insert(gone.end(), piece.tets.begin(), piece.tets.end());
        if (piece.volume > 0.0) {
            crumbs.debris.push_back({piece.moment / piece.mass, piece.momentum / piece.mass, piece.volume,
                                     piece.mass / piece.volume, piece.energy / piece.volume});
        }
    }
    crumbs.edit = remove_coarse(model, state, solid, gone);
    return crumbs;
}

}  // namespace rhexis
