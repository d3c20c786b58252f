// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to solve the linear systems of a sheet that is split in every step: conjugate gradients, each with another
// factor.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/methods/split_system.hpp"
#include "math/pcg.hpp"

namespace rhexis::bench {

class SplitSolver {
public:
    virtual ~SplitSolver() = default;

    struct Report {
        double factor_s = 0.0;  ///< thread CPU time of order, analysis and factor, or of the change to it
        double solve_s = 0.0;   ///< that of the iterations
        int iterations = 0;
        long entries = 0;       ///< numbers of the factor, those of a correction to it included
        bool factored = false;  ///< made anew
    };
    /// Solves the systems of one split after the other to a relative residual. x: 3 per row of the system.
    virtual Report solve(const SplitSystem& system, double tolerance, std::vector<double>& x) = 0;
};

enum class SplitMethod {
    anew,         ///< a new order, the better of minimum degree and nested dissection; single precision
    anew_double,  ///< a new order of minimum degree; CHOLMOD in double precision
    stale,        ///< the factor of an earlier sheet, the blocks of the diagonal at nodes that are new
    updown,       ///< CHOLMOD's factor, updated and downdated
    woodbury,     ///< the factor of an earlier sheet and a dense correction at the nodes that splits touched
};
const char* name_of(SplitMethod method);

/// splits: solved with one factor before it is made anew, in the order kept from sheet to sheet; 1: in each, which with
/// `stale` is what the kernel does. Not for the first two methods.
std::unique_ptr<SplitSolver> split_solver(SplitMethod method, int splits);

}  // namespace rhexis::bench
