// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: linear solves of similar systems, one after the other, by conjugate gradients with a factor that is
// kept while that pays. When it is made anew depends on counts alone, never on a clock.
#pragma once

#include <vector>

#include "math/pcg.hpp"
#include "physics/solve/factor_preconditioner.hpp"
#include "physics/solve/past_solutions.hpp"

namespace rhexis {

class KeptSolver {
public:
    KeptSolver(const BlockPattern& pattern, const linear_kernel::Kernel& kernel) : factor_(pattern, kernel) {}

    struct Outcome {
        int iterations = 0;
        double residual = 0.0;  ///< |b - A x|, absolute
        bool converged = false;
        bool factored = false;
    };

    /// x = A^-1 b until |b - A x| <= tolerance (absolute). single_only: else not converged.
    Outcome solve(const CoupledMatrix& matrix, std::span<const double> b, double tolerance, int max_iterations,
                  std::span<double> x, bool single_only = false);

    /// As a new solver of another pattern, in the memory that is there. row_now: as of PackedFactor.
    void follow(const BlockPattern& pattern, std::span<const int> row_now) {
        factor_.follow(pattern, row_now);
        drop();
        solves_ = iterations_ = last_ = first_ = 0;
    }
    /// Whether a factor that did not serve is tried ever more seldom: pays where few of them do.
    void try_seldom(bool seldom) { seldom_ = seldom; }
    /// Whether solves with a kept factor begin from what earlier solutions span: pays where each is like the last.
    void foretell(bool foretells) { foretells_ = foretells; }
    /// Forgets the factor and what was learned of its use: the next solve is as that of a new solver.
    void drop();
    /// The next solve makes a new factor.
    void expect_change() { due_ = true; }

private:
    [[nodiscard]] bool due(const CoupledMatrix& matrix) const;
    bool renew(const CoupledMatrix& matrix, FactorPreconditioner::Precision precision, bool single_only,
               Outcome& outcome);
    PcgResult run(const CoupledMatrix& matrix, std::span<const double> b, double tolerance, int max_iterations,
                  std::span<double> x, PcgStart start);

    FactorPreconditioner factor_;
    PastSolutions past_;
    PcgWork work_;
    bool due_ = true;
    int solves_ = 0;      ///< with the kept factor
    int iterations_ = 0;  ///< in all of them
    int last_ = 0;        ///< in the last one
    int first_ = 0;       ///< in the first one
    bool seldom_ = false;
    bool foretells_ = false;
    int wait_ = 0;     ///< solves without trying an earlier factor, after the last that did not serve
    int waiting_ = 0;  ///< of these still to come
};

}  // namespace rhexis
