// SPDX-License-Identifier: GPL-3.0-or-later
// A flat triangle of a thin shell whose corners move and turn through any angle while it strains little: plate and
// membrane (dkt_plate.hpp, drilling_membrane.hpp) in a frame that goes with it, independent of what the element is
// [FelippaHaugen2005], [NourOmidRankin1991].
//
// Frame E: its normal, and in its plane the rotation of the polar decomposition, so that numbering does not matter.
// With X the rest positions in the rest frame E0, both about the middle, and Q_a the rotations of the corners since
// rest,
//
//   u_a = E' (x_a - middle) - X_a,   theta_a = 4 tan(angle / 4) axis of E' Q_a E0,   d = (u, theta)
//   W = 1/2 (d - natural)' K (d - natural)
//
// natural is zero for an elastic triangle; a viscoelastic one flows, and with it the shape in which it bears no stress
// (zener.hpp). Below, K d stands for K (d - natural).
//
// theta is the stereographic rotation vector [Schaub1996]: it differs from angle times axis by angle^2 / 48, which
// refinement takes away, is one to one for whole turns, and needs a root and a division instead of trigonometry. Its
// rate for a spin w is H w, H = (1 - |theta|^2/16) 1 - [theta]x/2 + theta theta'/8.
//
// With G the spin of E per movement, S the movement per spin (p_a x ., 1), P = 1 - S G:
//   gradient (per movement and spin)  g = E P' H' K d
//   tangent  sym{ P' (H' K H + d(H' m)/dtheta H) P - F_nm G - G' F_n' P - (dG') S' H' K d }, turned by E
// F_n, F_nm: cross matrices of the forces, and of forces and moments. The derivative of g by spins is not symmetric
// away from equilibrium; its symmetric part, taken here, is the second derivative of W along rotations about fixed
// axes, and the rest cancels between the triangles of a corner on which no outer moment acts, so Newton keeps its
// quadratic rate [NourOmidRankin1991]. The last term is left out by [FelippaHaugen2005] as small; with it the tangent
// is exact.
#pragma once

#include <array>

#include "energy/plane_corners.hpp"

namespace rhexis {

using Vec18 = Eigen::Matrix<double, 18, 1>;
using Mat18 = Eigen::Matrix<double, 18, 18>;
using Vec15 = Eigen::Matrix<double, 15, 1>;

/// What a triangle is at rest. Built once.
struct ShellTriangle {
    PlaneCorners corner{};          ///< about its middle, in its own frame [mm]
    Mat3 frame = Mat3::Identity();  ///< its axes at rest, in columns; the third is the normal
    Mat9 membrane = Mat9::Zero();   ///< for (u, v, theta_z) of each corner
    Mat9 bending = Mat9::Zero();    ///< for (w, theta_x, theta_y) of each corner
    Mat3 tension = Mat3::Zero();    ///< force per length over strain [uN/mm]
    Vec15 natural = Vec15::Zero();  ///< deformation at which it bears no stress, as of shell_deformation
};

/// thickness [mm], > 0; young_modulus [Pa], > 0; poisson_ratio: -1 < nu <= 0.5; the rest points must span an area.
ShellTriangle shell_triangle(const std::array<Vec3, 3>& rest, double thickness, double young_modulus,
                             double poisson_ratio);

/// How a triangle is made of the same: a seam for measuring other plates and membranes in the same frame.
using ShellTriangleMaker = ShellTriangle (*)(const std::array<Vec3, 3>& rest, double thickness, double young_modulus,
                                             double poisson_ratio);

/// Where the corners of a triangle are and how they have turned since rest.
struct ShellCorners {
    std::array<Vec3, 3> position{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< [mm]
    std::array<Mat3, 3> rotation{Mat3::Identity(), Mat3::Identity(), Mat3::Identity()};
};

/// Of each corner u, v [mm], then theta in the triangle's frame; the same however the triangle turns and moves.
Vec15 shell_deformation(const ShellTriangle& triangle, const ShellCorners& corners);

/// Product of two deformations by the stiffness, a' K b [nJ].
double shell_product(const ShellTriangle& triangle, const Vec15& a, const Vec15& b);

/// Energy [nJ].
double shell_energy(const ShellTriangle& triangle, const ShellCorners& corners);

/// Energy and its derivative for movement, then spin, of each corner [uN, uN mm]; the internal force is its negative.
double shell_gradient(const ShellTriangle& triangle, const ShellCorners& corners, Vec18& gradient);

enum class ShellTangent {
    consistent,  ///< the second derivative, along rotations about fixed axes
    definite,    ///< P' H' K H P and the stiffness of tension: positive semidefinite
};

/// The same with the second derivative, symmetric [uN/mm, uN, uN mm].
double shell_hessian(const ShellTriangle& triangle, const ShellCorners& corners, ShellTangent kind, Vec18& gradient,
                     Mat18& hessian);

}  // namespace rhexis
