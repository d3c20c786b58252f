// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a kept factor of a coupled matrix, used to precondition those of later steps.
//
// With A = L L' (sparse), X = A^-1 C and S = B - C' X (dense, six rows per body) all of the time of factoring:
//   z_rigid = S^-1 (r_rigid - X' r_solid),  z_solid = A^-1 r_solid - X z_rigid
// is the inverse of that matrix, so stiff contacts on a light body cost no iterations. L is kept in single precision;
// if that does not exist, in double (CHOLMOD), which takes about ten times as long.
#pragma once

#include <Eigen/Cholesky>
#include <optional>
#include <span>

#include "math/cholesky.hpp"
#include "math/packed_factor.hpp"
#include "physics/solve/coupled_matrix.hpp"

namespace rhexis {

class FactorPreconditioner {
public:
    /// The pattern must outlive this; rows in an order of elimination.
    FactorPreconditioner(const BlockPattern& pattern, const linear_kernel::Kernel& kernel);

    /// Takes over another pattern, in the memory that is there; nothing is kept then. row_now: as of PackedFactor.
    void follow(const BlockPattern& pattern, std::span<const int> row_now);

    enum class Precision { single, twofold };

    /// False if the matrix is not positive definite or not finite: then nothing is kept. Single precision turns to
    /// double by itself where it must, unless single_only.
    bool factor(const CoupledMatrix& matrix, Precision precision, bool single_only = false);
    void drop() { kept_ = false; }
    [[nodiscard]] bool kept() const { return kept_; }
    [[nodiscard]] Precision precision() const { return precision_; }
    [[nodiscard]] int bodies() const { return static_cast<int>(coupling_.cols() / 6); }
    /// What making a factor costs, in iterations that use it.
    [[nodiscard]] double cost_in_iterations() const;

    void apply(std::span<const double> r, std::span<double> z);

private:
    void solve_solid(const double* r, double* z);
    bool factor_solid(const BlockValues& values, Precision precision, bool single_only);

    const BlockPattern* pattern_;
    PackedFactor packed_;
    std::optional<Cholesky> exact_;  ///< made when first needed
    std::vector<float> single_;
    MatX coupling_;  ///< C
    MatX carried_;   ///< X
    Eigen::LLT<MatX> schur_;
    Precision precision_ = Precision::single;
    bool kept_ = false;
};

}  // namespace rhexis
