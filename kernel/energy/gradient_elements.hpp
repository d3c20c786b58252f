// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of constant deformation gradient, made from a tetrahedral mesh. Everything that knows the corotational
// energy of a gradient can step them.
//
//   F = sum_a x_a (x) b_a,  f_a = -V P(F) b_a,  K_ab = V (b_a . dP/dF . b_b)
//
// linear:         one element per tetrahedron; b_a are the gradients of the linear shape functions.
// edge_smoothed:  one element per edge: the gradient is the volume mean over the tetrahedra around the edge, each
//                 giving a sixth of its volume to each of its edges [He2013]. That takes the shear locking out of
//                 linear tetrahedra. What a bulk near incompressibility locks goes over patches of four tetrahedra
//                 instead [deSouzaNeto2005]: elements of their own, for lambda beyond mu (Poisson's ratio 0.25), which
//                 no mesh locks; bulk that were left to patches alone would leave the mesh too soft.
// nodal_pressure: linear, but the elements keep the part of the energy that changes shape (lambda = -2/3 mu); the part
//                 that changes volume is one of node patches (energy/nodal_pressure.hpp).
#pragma once

#include <vector>

#include "mesh/tet_mesh.hpp"

namespace rhexis {

enum class Formulation { linear, edge_smoothed, nodal_pressure };

/// What a tetrahedron contributes: Lame parameters [Pa] and the share of its volume that still carries load (0: none).
struct TetStiffness {
    double lambda = 0.0;
    double mu = 0.0;
    double share = 1.0;
};

/// Compressed rows: element e uses entries first[e] .. first[e + 1] - 1 of node and gradient. Within an element the
/// gradients sum to zero, so that a translation has no energy. An element without load-bearing volume has volume 0.
struct GradientElements {
    std::vector<int> first;
    std::vector<int> node;
    std::vector<Vec3> gradient;  ///< b_a [1/mm]
    std::vector<double> volume;  ///< load-bearing [mm^3]
    std::vector<double> lambda;  ///< [Pa]
    std::vector<double> mu;      ///< [Pa]

    [[nodiscard]] int count() const { return static_cast<int>(volume.size()); }
};

/// Which tetrahedra each element is made of; constant for a mesh. Shares change, this does not.
struct ElementDomains {
    Formulation formulation = Formulation::linear;
    int first_patch = 0;     ///< elements from here on are patches: they have no mu
    std::vector<int> first;  ///< element e: tets[first[e]] .. tets[first[e + 1] - 1]
    std::vector<int> tets;
    std::vector<int> of_tet_first;    ///< tetrahedron t: of_tet[of_tet_first[t]] ..
    std::vector<int> of_tet;          ///< elements that tetrahedron t takes part in, ascending
    std::vector<double> rest_volume;  ///< per tetrahedron [mm^3]
    std::vector<Vec3> rest_gradient;  ///< 4 per tetrahedron [1/mm]
};

/// mesh must be valid (positive volumes).
ElementDomains element_domains(const TetMesh& mesh, Formulation formulation);

/// All elements for given contributions, one per tetrahedron.
GradientElements make_elements(const TetMesh& mesh, const ElementDomains& domains,
                               const std::vector<TetStiffness>& stiffness);

/// Recomputes the elements that the named tetrahedra take part in, after their shares changed.
void update_elements(const TetMesh& mesh, const ElementDomains& domains, const std::vector<TetStiffness>& stiffness,
                     const std::vector<int>& changed_tets, GradientElements& elements);

}  // namespace rhexis
