// SPDX-License-Identifier: GPL-3.0-or-later
// One linear tetrahedron of corotational material: energy, force and stiffness of its four nodes.
//   F = sum_a x_a (x) b_a,  E = V psi(F),  dE/dx_a = V P b_a,  K_ab = V (b_a . dP/dF . b_b)
#pragma once

#include <array>

#include "energy/corotational.hpp"

namespace rhexis {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;
using TetPoints = std::array<Vec3, 4>;

/// What a tetrahedron keeps of its rest shape.
struct RestTet {
    std::array<Vec3, 4> gradient;  ///< b_a of the linear shape functions [1/mm]; they sum to zero
    double volume = 0.0;           ///< [mm^3]
};

/// rest must be positively oriented.
RestTet rest_tet(const TetPoints& rest);

/// F of the tetrahedron at positions x.
Mat3 tet_gradient(const RestTet& tet, const TetPoints& x);

/// Share of a tetrahedron's stiffness and inertia for the fraction of it that is left: the fraction, but no less than
/// `floor` while there is anything, so that the stable step survives; 0 once it is gone.
double load_bearing_share(double fraction, double floor);

/// Energy [nJ].
double corotational_tet_energy(const RestTet& tet, const Lame& material, const TetPoints& x);

/// Derivative of the energy by the 12 coordinates [uN]; the internal force is its negative.
Vec12 corotational_tet_gradient(const RestTet& tet, const Lame& material, const TetPoints& x);

/// Second derivative, or the stand-in for it that `kind` names [uN/mm].
Mat12 corotational_tet_hessian(const RestTet& tet, const Lame& material, const TetPoints& x, Tangent kind);

}  // namespace rhexis
