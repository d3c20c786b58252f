// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's own factor as the methods of this folder use it.
#pragma once

#include "bench/methods/split_system.hpp"
#include "math/pcg.hpp"
#include "physics/solve/factor_preconditioner.hpp"

namespace rhexis::bench {

/// Of the sheet's matrix, rows by nodes.
BlockPattern node_pattern(const SplitSystem& system);

/// Numbers of the factor of a matrix whose rows are in an order of elimination.
long factor_entries(const BlockPattern& pattern);

/// Conjugate gradients to a relative residual with the factor of this very matrix. Returns the iterations.
int iterate(const SplitSystem& system, double tolerance, FactorPreconditioner& factor, std::vector<double>& x,
            PcgWork& work);

}  // namespace rhexis::bench
