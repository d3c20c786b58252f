// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues and vectors of a symmetric 3x3 matrix by Jacobi rotations: only + - * / sqrt, so the bits do not depend
// on the C library, and orthogonal vectors also where eigenvalues coincide.
#pragma once

#include "math/types.hpp"

namespace rhexis {

/// matrix = vectors * diag(values) * vectors^T; values in no order, vectors in columns, right-handed.
struct SymmetricEigen3 {
    Vec3 values = Vec3::Zero();
    Mat3 vectors = Mat3::Identity();
};

/// Reads the lower triangle.
SymmetricEigen3 symmetric_eigen(const Mat3& matrix);

}  // namespace rhexis
