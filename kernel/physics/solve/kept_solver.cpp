// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solve/kept_solver.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {
namespace {

using Precision = FactorPreconditioner::Precision;

constexpr int patience = 40;      // iterations after which a new factor in single precision is not trusted
constexpr int longest_wait = 32;  // solves for which no earlier factor is tried, where none served

}  // namespace

void KeptSolver::drop() {
    factor_.drop();
    past_.forget();
    due_ = true;
    wait_ = waiting_ = 0;
}

/// A new factor pays once a solve costs more than the mean of all with this factor, its making included.
bool KeptSolver::due(const CoupledMatrix& matrix) const {
    if (due_ || !factor_.kept() || 6 * factor_.bodies() != matrix.rigid().rows()) {
        return true;
    }
    return solves_ > 0 && last_ * solves_ > factor_.cost_in_iterations() + iterations_;
}

bool KeptSolver::renew(const CoupledMatrix& matrix, Precision precision, bool single_only, Outcome& outcome) {
    solves_ = iterations_ = last_ = first_ = 0;
    due_ = true;
    outcome.factored = true;
    if (!factor_.factor(matrix, precision, single_only)) {
        return false;
    }
    due_ = false;
    return true;
}

PcgResult KeptSolver::run(const CoupledMatrix& matrix, std::span<const double> b, double tolerance, int max_iterations,
                          std::span<double> x, PcgStart start) {
    const auto multiply = [&matrix](std::span<const double> in, std::span<double> out) { matrix.multiply(in, out); };
    const auto precondition = [this](std::span<const double> r, std::span<double> z) { factor_.apply(r, z); };
    return pcg(b, tolerance, max_iterations, multiply, precondition, x, start, work_);
}

KeptSolver::Outcome KeptSolver::solve(const CoupledMatrix& matrix, std::span<const double> b, double tolerance,
                                      int max_iterations, std::span<double> x, bool single_only) {
    Outcome outcome;
    PcgResult result;
    PcgStart start = PcgStart::zero;
    const auto attempt = [&](int limit) {
        result = run(matrix, b, tolerance, std::min(limit, max_iterations - outcome.iterations), x, start);
        outcome.iterations += result.iterations;
        start = PcgStart::from_x;
    };
    const bool known = !due(matrix);
    if (known && waiting_ == 0) {
        if (foretells_ && past_.any(b.size())) {
            work_.resize(b.size());
            past_.project(matrix, b, x, work_.image);
            start = PcgStart::with_image;
        }
        // an old factor that does far worse than when it was new is given up on the way
        attempt(first_ + std::max(4, static_cast<int>(factor_.cost_in_iterations())));
        wait_ = result.converged || !seldom_ ? 0 : std::min(2 * wait_ + 1, longest_wait);
        waiting_ = wait_;
    } else if (known) {
        --waiting_;
    }
    if (start == PcgStart::zero || (!result.converged && result.finite)) {
        if (renew(matrix, Precision::single, single_only, outcome)) {
            attempt(factor_.precision() == Precision::single ? patience : max_iterations);
            if (!single_only && !result.converged && result.finite && factor_.precision() == Precision::single &&
                renew(matrix, Precision::twofold, single_only, outcome)) {
                attempt(max_iterations);
            }
        } else if (start == PcgStart::zero) {
            std::fill(x.begin(), x.end(), 0.0);
            result.residual = std::sqrt(dot(b, b));
        }
        first_ = result.iterations;
    }
    if (foretells_ && result.finite) {
        past_.keep(x);
    } else {
        past_.forget();
    }
    ++solves_;
    last_ = outcome.iterations;
    iterations_ += last_;
    outcome.residual = result.residual;
    outcome.converged = result.converged;
    return outcome;
}

}  // namespace rhexis
