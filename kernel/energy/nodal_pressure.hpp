// SPDX-License-Identifier: GPL-3.0-or-later
// Volume change averaged over the patch of each node: the energy that changes volume in Formulation::nodal_pressure
// [Bonet1998, in corotational form].
//
//   theta_t = tr S(F_t) - 3,  w_t = share V_t / 4,  V_n = sum_t w_t,  theta_n = sum_t w_t theta_t / V_n
//   E = sum_n 1/2 k_n V_n theta_n^2,  p_n = k_n theta_n,  k_n = sum_t w_t k_t / V_n,  k = lambda + 2/3 mu
//
// over the tetrahedra t around node n. There are fewer nodes than tetrahedra: near incompressibility the mesh keeps
// freedoms that linear tetrahedra lose. E is never larger than that of the tetrahedra themselves.
#pragma once

#include <vector>

#include "energy/gradient_elements.hpp"

namespace rhexis {

/// Patches of a mesh; entries are per node.
struct NodePatches {
    std::vector<double> volume;  ///< V_n [mm^3]; 0 for a node without load-bearing tetrahedra
    std::vector<double> bulk;    ///< k_n [Pa]; 0 where the volume is
};

/// rest_volume and stiffness: one per tetrahedron. stiffness with the whole lambda, not that of the elements.
NodePatches node_patches(const TetMesh& mesh, const std::vector<double>& rest_volume,
                         const std::vector<TetStiffness>& stiffness);

/// E [nJ] for the volume change theta_t of every tetrahedron.
double nodal_pressure_energy(const TetMesh& mesh, const std::vector<double>& rest_volume,
                             const std::vector<TetStiffness>& stiffness, const NodePatches& patches,
                             const std::vector<double>& theta);

/// dE / dtheta_t over the load-bearing volume of t: the mean of p_n over its nodes [Pa]; 0 where nothing is left.
std::vector<double> tet_pressures(const TetMesh& mesh, const std::vector<double>& rest_volume,
                                  const std::vector<TetStiffness>& stiffness, const NodePatches& patches,
                                  const std::vector<double>& theta);

}  // namespace rhexis
