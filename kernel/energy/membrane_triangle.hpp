// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle of a thin sheet that strains in its plane, with linear shape functions: energy, forces and stiffness.
//
//   F = sum x_a g_a^T (3x2),  C = F^T F,  W = A h w(strain(C)),  f_a = -dW/dx_a
//   K_ab = A h [ sum_kl D_kl (dC_k/dx_a)(dC_l/dx_b)^T + (g_a . S g_b) I ],  s = dw/dC, S = [2 s11, s12; s12, 2 s22]
//
// strain() is that of energy/metric_strain.hpp, so no rotation and no frame in space appears; w() is the orthotropic
// energy without compression (energy/tension_field.hpp). The last term is the stiffness that stress gives a sheet at a
// right angle to itself: without it a taut sheet shakes itself apart in steps longer than its own period.
#pragma once

#include <array>

#include "energy/tension_field.hpp"
#include "math/types.hpp"

namespace rhexis {

/// What a triangle is at rest. Built once.
struct MembraneTriangle {
    std::array<Vec2, 3> gradient{};  ///< of the shape functions in its own plane frame [1/mm]
    double volume = 0.0;             ///< area times thickness [mm^3]
    Mat3 stiffness = Mat3::Zero();   ///< plane_stiffness() in that frame [Pa]
    double rest = 0.0;               ///< share of it that stays in compression
};

using TrianglePoints = std::array<Vec3, 3>;

/// Frame of a triangle at rest: unit vectors in its plane, e1 along its first edge.
struct PlaneFrame {
    Vec3 e1 = Vec3::UnitX();
    Vec3 e2 = Vec3::UnitY();

    [[nodiscard]] Vec2 to_plane(const Vec3& v) const { return {e1.dot(v), e2.dot(v)}; }
    [[nodiscard]] Vec3 to_space(const Vec2& v) const { return v.x() * e1 + v.y() * e2; }
};
PlaneFrame plane_frame(const TrianglePoints& rest);

/// Gradients of the shape functions in a frame [1/mm]; the triangle must have an area.
std::array<Vec2, 3> shape_gradients(const TrianglePoints& rest, const PlaneFrame& frame);

/// Metric of the deformed triangle: (c11, c22, c12).
Vec3 metric_of(const MembraneTriangle& triangle, const TrianglePoints& x);

enum class MembraneTangent {
    consistent,  ///< derivative of the forces
    definite,    ///< without what makes it indefinite: positive semidefinite
};

/// Energy of the triangle [nJ], stress and tangent in its own frame.
TensionField membrane_state(const MembraneTriangle& triangle, const TrianglePoints& x);

/// Energy [nJ] and forces -dW/dx [uN].
double membrane_forces(const MembraneTriangle& triangle, const TrianglePoints& x, TrianglePoints& force);

/// Blocks (a, b) with a <= b of the stiffness: 00, 01, 02, 11, 12, 22 [uN/mm].
using TriangleBlocks = std::array<Mat3, 6>;

/// The same with the stiffness.
double membrane_stiffness(const MembraneTriangle& triangle, const TrianglePoints& x, MembraneTangent kind,
                          TrianglePoints& force, TriangleBlocks& blocks);

}  // namespace rhexis
