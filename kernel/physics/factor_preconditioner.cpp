// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/factor_preconditioner.hpp"

namespace rhexis {

FactorPreconditioner::FactorPreconditioner(const BlockPattern& pattern)
    : cholesky_(pattern, CholeskyKind::simplicial) {}

bool FactorPreconditioner::factor(const CoupledMatrix& matrix) {
    kept_ = cholesky_.factor(matrix.solid_within_pattern());
    if (!kept_) {
        return false;
    }
    coupling_ = matrix.coupling();
    carried_.resize(coupling_.rows(), coupling_.cols());
    const std::size_t n = matrix.solid_size();
    for (Eigen::Index column = 0; column < coupling_.cols(); ++column) {
        cholesky_.solve({coupling_.col(column).data(), n}, {carried_.col(column).data(), n});
    }
    if (coupling_.cols() > 0) {
        const MatX schur = matrix.rigid() - coupling_.transpose() * carried_;
        schur_.compute(0.5 * (schur + schur.transpose()));
        kept_ = schur_.info() == Eigen::Success;
    }
    return kept_;
}

void FactorPreconditioner::apply(std::span<const double> r, std::span<double> z) {
    cholesky_.solve(r, z);
    if (coupling_.cols() == 0) {
        return;
    }
    const Eigen::Index n = coupling_.rows();
    Eigen::Map<VecX> solid(z.data(), n);
    Eigen::Map<VecX> rigid(z.data() + n, coupling_.cols());
    const Eigen::Map<const VecX> rigid_r(r.data() + n, coupling_.cols());
    rigid = schur_.solve(rigid_r - coupling_.transpose() * solid);
    solid -= carried_ * rigid;
}

}  // namespace rhexis
