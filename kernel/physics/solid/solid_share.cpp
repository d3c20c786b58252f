// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/solid_share.hpp"

#include "energy/corotational_tet.hpp"

namespace rhexis {

std::vector<TetStiffness> tet_stiffness(const SolidModel& model, const SolidState& state) {
    std::vector<TetStiffness> result(model.coarse.tets.size());
    for (std::size_t t = 0; t < result.size(); ++t) {
        const Material& material = model.materials[static_cast<std::size_t>(model.coarse.region[t])];
        const Lame moduli = lame(material.young_modulus, material.poisson_ratio);
        const double left = state.present[t] != 0 ? remaining_fraction(model, state, static_cast<int>(t)) : 0.0;
        result[t] = {moduli.lambda, moduli.mu, load_bearing_share(left, model.stiffness_floor)};
    }
    return result;
}

NodeMass node_mass(const SolidModel& model, const SolidState& state, const std::vector<TetStiffness>& stiffness) {
    const TetMesh& mesh = model.coarse;
    NodeMass result;
    result.inertia.assign(mesh.nodes.size(), 0.0);
    result.weight.assign(mesh.nodes.size(), 0.0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        if (state.present[t] == 0) {
            continue;
        }
        const std::array<int, 4>& tet = mesh.tets[t];
        const Material& material = model.materials[static_cast<std::size_t>(mesh.region[t])];
        const double quarter = 0.25 * tet_volume(mesh.nodes[static_cast<std::size_t>(tet[0])],
                                                 mesh.nodes[static_cast<std::size_t>(tet[1])],
                                                 mesh.nodes[static_cast<std::size_t>(tet[2])],
                                                 mesh.nodes[static_cast<std::size_t>(tet[3])]);
        const double left = remaining_fraction(model, state, static_cast<int>(t));
        for (const int node : tet) {
            const auto i = static_cast<std::size_t>(node);
            result.inertia[i] += quarter * stiffness[t].share * material.density;
            result.weight[i] += quarter * left * (material.density - model.buoyancy_density);
        }
    }
    return result;
}

}  // namespace rhexis
