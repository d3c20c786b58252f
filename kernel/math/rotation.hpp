// SPDX-License-Identifier: GPL-3.0-or-later
// The rotation in a deformation gradient, without a singular value decomposition.
//
// F = R S with det R = +1 and S symmetric of the largest possible trace f: the signed stretches have at most one
// negative, the smallest in size. With I = F:F, e2 = (I^2 - C:C)/2, C = F^T F, J = det F, the trace is the largest root
// of
//     f^4 - 2 I f^2 - 8 J f + I^2 - 4 e2 = 0
// and  R = [(f^2 + I) F - 2 F C + 2 f cof F] / (f^3 - I f - 2 J)                                       [Lin2022]
// The denominator is 2 (s1+s2)(s2+s3)(s3+s1). It vanishes only where two stretches sum to zero and R is not unique;
// near there R is found by Newton's method on the rotations from the previous one.
#pragma once

#include "math/types.hpp"

namespace rhexis {

/// Cofactor matrix: det(F) F^-T, also defined where F is singular.
Mat3 cofactor(const Mat3& f);

/// The matrix [v]x with [v]x w = v x w.
Mat3 cross_matrix(const Vec3& v);

/// The vector v with A - A^T = [v]x.
Vec3 skew_vector(const Mat3& a);

/// Rotation by the vector w (angle |w| to third order in it): Cayley map, exactly orthogonal up to rounding.
Mat3 cayley(const Vec3& w);

/// The spin of cayley(z) Q, with Q constant, per change of z.
Mat3 spin_of_turn(const Vec3& z);

/// The shortest turn that lays the z axis along a direction of any length; half a turn about some axis for -z.
Quat turn_of_z(const Vec3& direction);

/// A rotation turned further by cayley(w), of unit length again.
Quat turned(const Quat& rotation, const Vec3& w);

/// The proper rotation R of F = R S. Finite for every finite F; `previous` decides where R is not unique.
Mat3 polar_rotation(const Mat3& f, const Mat3& previous = Mat3::Identity());

}  // namespace rhexis
