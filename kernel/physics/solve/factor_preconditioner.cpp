// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solve/factor_preconditioner.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace rhexis {

FactorPreconditioner::FactorPreconditioner(const BlockPattern& pattern, const linear_kernel::Kernel& kernel)
    : pattern_(&pattern), packed_(pattern, kernel), single_(4 * static_cast<std::size_t>(pattern.rows()), 0.0F) {}

void FactorPreconditioner::follow(const BlockPattern& pattern, std::span<const int> row_now) {
    pattern_ = &pattern;
    packed_.follow(pattern, row_now);
    exact_.reset();
    single_.assign(4 * at(pattern.rows()), 0.0F);
    coupling_.resize(0, 0);
    precision_ = Precision::single;
    kept_ = false;
}

double FactorPreconditioner::cost_in_iterations() const {
    // measured: multiply-adds of a factorisation run 2 to 3 times as fast as those of an iteration, which wait for
    // memory
    const double single = packed_.factor_work() / (2.4 * packed_.solve_work());
    return precision_ == Precision::single ? single : 5.0 * single;
}

bool FactorPreconditioner::factor_solid(const BlockValues& values, Precision precision, bool single_only) {
    precision_ = precision;
    if (precision == Precision::single && packed_.factor(values)) {
        return true;
    }
    if (single_only) {
        return false;
    }
    precision_ = Precision::twofold;
    if (!exact_) {
        exact_.emplace(*pattern_, CholeskyKind::simplicial);
    }
    return exact_->factor(values);
}

bool FactorPreconditioner::factor(const CoupledMatrix& matrix, Precision precision, bool single_only) {
    kept_ = matrix.has_links() ? factor_solid(matrix.solid_within_pattern(), precision, single_only)
                               : factor_solid(matrix.solid(), precision, single_only);
    if (!kept_) {
        return false;
    }
    coupling_ = matrix.coupling();
    carried_.resize(coupling_.rows(), coupling_.cols());
    for (Eigen::Index column = 0; column < coupling_.cols(); ++column) {
        solve_solid(coupling_.col(column).data(), carried_.col(column).data());
    }
    if (coupling_.cols() > 0) {
        const MatX schur = matrix.rigid() - coupling_.transpose() * carried_;
        schur_.compute(0.5 * (schur + schur.transpose()));
        kept_ = schur_.info() == Eigen::Success;
        if (!kept_ && precision_ == Precision::single && !single_only) {
            return factor(matrix, Precision::twofold);
        }
    }
    return kept_;
}

void FactorPreconditioner::solve_solid(const double* r, double* z) {
    const std::size_t rows = single_.size() / 4;
    if (precision_ == Precision::twofold) {
        exact_->solve({r, 3 * rows}, {z, 3 * rows});
        return;
    }
    double largest = 0.0;
    for (std::size_t i = 0; i < 3 * rows; ++i) {
        largest = std::max(largest, std::abs(r[i]));
    }
    // to the middle of single precision's range
    const double scale = largest > 0.0 ? 1.0 / largest : 1.0;
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            single_[4 * i + c] = static_cast<float>(scale * r[3 * i + c]);
        }
    }
    packed_.solve(single_);
    const double back = largest > 0.0 ? largest : 1.0;
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            z[3 * i + c] = back * static_cast<double>(single_[4 * i + c]);
        }
    }
}

void FactorPreconditioner::apply(std::span<const double> r, std::span<double> z) {
    solve_solid(r.data(), z.data());
    if (coupling_.cols() == 0) {
        return;
    }
    const Eigen::Index n = coupling_.rows();
    const Eigen::Map<const VecX> solid_r(r.data(), n);
    const Eigen::Map<const VecX> rigid_r(r.data() + n, coupling_.cols());
    Eigen::Map<VecX> solid(z.data(), n);
    Eigen::Map<VecX> rigid(z.data() + n, coupling_.cols());
    rigid = schur_.solve(rigid_r - carried_.transpose() * solid_r);
    solid -= carried_ * rigid;
}

}  // namespace rhexis
