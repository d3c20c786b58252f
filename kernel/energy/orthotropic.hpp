// SPDX-License-Identifier: GPL-3.0-or-later
// A sheet with fibres in plane stress: stiffer along them than across.
//
// Strain and stress in a plane frame are written (11, 22, shear): strain with the engineering shear 2 e12. With f the
// fibre, M = f f^T, Q the stiffness in the fibre's own frame,
//   sigma = a tr(eps) I + 2 G eps + b [(f.eps f) I + tr(eps) M] + d (f.eps f) M,
//   a = Q22 - 2 G, b = Q12 - Q22 + 2 G, d = Q11 + Q22 - 2 Q12 - 4 G,
// which is the rotated orthotropic matrix of [Jones1999] without angles. [Dequidt2013] prints its entry 33 without a
// square and with another shear modulus: indefinite for fibres beyond some 50 degrees (test_kernel_energy shows it).
#pragma once

#include <string>

#include "base/result.hpp"
#include "math/types.hpp"

namespace rhexis {

struct Orthotropic {
    double along = 1.0e6;         ///< Young's modulus along the fibre [Pa], > 0
    double across = 1.0e6;        ///< and across it [Pa], > 0
    double poisson_ratio = 0.45;  ///< contraction across when pulled along; its square < along / across
    double shear_modulus = 0.0;   ///< [Pa], > 0; 0: the harmonic one, below
};

/// Isotropic: both moduli the same, shear modulus E / (2 (1 + nu)).
Orthotropic isotropic(double young_modulus, double poisson_ratio);

/// 1 / G = (1 + nu_along) / along + (1 + nu_across) / across [Pa]: then 1 / E(angle) = cos^2 / along + sin^2 / across,
/// and the isotropic limit is right. Used where no shear test is known.
double harmonic_shear_modulus(const Orthotropic& material);

/// Error unless the energy is positive for every strain. where: for the message.
Status check_orthotropic(const Orthotropic& material, const std::string& where);

/// Stress over strain [Pa] where the fibre points along (cos, sin) of the frame. fibre: unit.
Mat3 plane_stiffness(const Orthotropic& material, const Vec2& fibre);

/// Young's modulus in a direction at an angle [rad] from the fibre [Pa]: closed form.
double off_axis_modulus(const Orthotropic& material, double angle);

}  // namespace rhexis
