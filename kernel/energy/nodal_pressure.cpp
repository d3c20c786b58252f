// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/nodal_pressure.hpp"

namespace rhexis {
namespace {

double weight(const std::vector<double>& rest_volume, const std::vector<TetStiffness>& stiffness, std::size_t t) {
    return 0.25 * stiffness[t].share * rest_volume[t];
}

/// theta_n V_n
std::vector<double> gathered(const TetMesh& mesh, const std::vector<double>& rest_volume,
                             const std::vector<TetStiffness>& stiffness, const std::vector<double>& theta) {
    std::vector<double> sum(mesh.nodes.size(), 0.0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        for (const int node : mesh.tets[t]) {
            sum[static_cast<std::size_t>(node)] += weight(rest_volume, stiffness, t) * theta[t];
        }
    }
    return sum;
}

}  // namespace

NodePatches node_patches(const TetMesh& mesh, const std::vector<double>& rest_volume,
                         const std::vector<TetStiffness>& stiffness) {
    NodePatches patches;
    patches.volume.assign(mesh.nodes.size(), 0.0);
    patches.bulk.assign(mesh.nodes.size(), 0.0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const double part = weight(rest_volume, stiffness, t);
        const double bulk = stiffness[t].lambda + 2.0 / 3.0 * stiffness[t].mu;
        for (const int node : mesh.tets[t]) {
            patches.volume[static_cast<std::size_t>(node)] += part;
            patches.bulk[static_cast<std::size_t>(node)] += part * bulk;
        }
    }
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        patches.bulk[n] = patches.volume[n] > 0.0 ? patches.bulk[n] / patches.volume[n] : 0.0;
    }
    return patches;
}

double nodal_pressure_energy(const TetMesh& mesh, const std::vector<double>& rest_volume,
                             const std::vector<TetStiffness>& stiffness, const NodePatches& patches,
                             const std::vector<double>& theta) {
    const std::vector<double> sum = gathered(mesh, rest_volume, stiffness, theta);
    double energy = 0.0;
    for (std::size_t n = 0; n < sum.size(); ++n) {
        if (patches.volume[n] > 0.0) {
            energy += 0.5 * patches.bulk[n] * sum[n] * sum[n] / patches.volume[n];
        }
    }
    return energy;
}

std::vector<double> tet_pressures(const TetMesh& mesh, const std::vector<double>& rest_volume,
                                  const std::vector<TetStiffness>& stiffness, const NodePatches& patches,
                                  const std::vector<double>& theta) {
    const std::vector<double> sum = gathered(mesh, rest_volume, stiffness, theta);
    std::vector<double> pressure(mesh.tets.size(), 0.0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        if (!(stiffness[t].share > 0.0)) {
            continue;
        }
        for (const int node : mesh.tets[t]) {
            const auto n = static_cast<std::size_t>(node);
            pressure[t] += 0.25 * patches.bulk[n] * sum[n] / patches.volume[n];
        }
    }
    return pressure;
}

}  // namespace rhexis
