// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a kept factor of a coupled matrix, used to precondition those of later steps.
//
// With A = L L' (sparse), X = A^-1 C and S = B - C' X (dense, six rows per body) all of the time of factoring:
//   y = A^-1 r_solid,  z_rigid = S^-1 (r_rigid - C' y),  z_solid = y - X z_rigid
// is the exact inverse of that matrix, so stiff contacts on a light body cost no iterations.
#pragma once

#include <Eigen/Cholesky>
#include <span>

#include "math/cholesky.hpp"
#include "physics/coupled_matrix.hpp"

namespace rhexis {

class FactorPreconditioner {
public:
    explicit FactorPreconditioner(const BlockPattern& pattern);

    /// False if the matrix is not positive definite or not finite: then nothing is kept.
    bool factor(const CoupledMatrix& matrix);
    void drop() { kept_ = false; }
    [[nodiscard]] bool kept() const { return kept_; }
    [[nodiscard]] int bodies() const { return static_cast<int>(coupling_.cols() / 6); }

    void apply(std::span<const double> r, std::span<double> z);

private:
    Cholesky cholesky_;
    MatX coupling_;  ///< C
    MatX carried_;   ///< X
    Eigen::LLT<MatX> schur_;
    bool kept_ = false;
};

}  // namespace rhexis
