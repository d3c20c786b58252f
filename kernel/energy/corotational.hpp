// SPDX-License-Identifier: GPL-3.0-or-later
// Linear elasticity in the frame that turns with the material: energy per volume of a deformation gradient F, its
// stress and its tangent.
//
//   F = R S,  psi = mu |F - R|^2 + lambda/2 (tr S - 3)^2,  P = 2 mu (F - R) + lambda (tr S - 3) R     [Mueller2004]
//
// Tangent. With g the rotated rest gradient R b, c = lambda (tr S - 3) - 2 mu and G = tr(S) I - S,
//   dP = 2 mu dF + lambda (R:dF) R + [H skew(dF R^T)]x R,  H = c R G^-1 R^T.
// H acts on rotations about the principal axes i alone ("twist modes"), whose stiffness is t_i = 2 mu + 2 h_i with
// h_i = c / (s_j + s_k) [Smith2019]. Warped: all t_i = 0, H = -mu I. Projected: t_i = max(t_i, 0).
#pragma once

#include "math/types.hpp"

namespace rhexis {

enum class Tangent {
    consistent,  ///< derivative of the stress; may be indefinite under compression
    warped,      ///< the linear stiffness turned by R: positive semidefinite, misses the stiffness of stress
    projected,   ///< consistent without its negative modes: positive semidefinite
};

/// Lame parameters [Pa] of Young's modulus > 0 [Pa] and Poisson's ratio in [0, 0.5).
struct Lame {
    double lambda = 0.0;
    double mu = 0.0;
};
Lame lame(double young_modulus, double poisson_ratio);

/// A deformation gradient taken apart.
struct CorotationalPoint {
    Mat3 gradient = Mat3::Identity();  ///< F
    Mat3 rotation = Mat3::Identity();  ///< R
    double trace = 3.0;                ///< tr S
};

/// `previous` decides the rotation where it is not unique.
CorotationalPoint corotational_point(const Mat3& gradient, const Mat3& previous = Mat3::Identity());

/// Energy per rest volume [Pa].
double corotational_energy(const CorotationalPoint& point, const Lame& material);

/// First Piola-Kirchhoff stress [Pa]: force on node a of an element is -V P b_a.
Mat3 corotational_stress(const CorotationalPoint& point, const Lame& material);

/// dP/dF at a point.
struct CorotationalTangent {
    Mat3 rotation = Mat3::Identity();  ///< R
    Mat3 twist = Mat3::Zero();         ///< H, symmetric [Pa]
    Lame material;

    /// dP for dF.
    [[nodiscard]] Mat3 stress_change(const Mat3& change) const;
    /// Stiffness per rest volume between two nodes with rest gradients a and b: d(P a)/dx_b [Pa/mm^2].
    [[nodiscard]] Mat3 block(const Vec3& a, const Vec3& b) const;
};
CorotationalTangent corotational_tangent(const CorotationalPoint& point, const Lame& material, Tangent kind);

}  // namespace rhexis
