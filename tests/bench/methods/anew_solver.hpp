// SPDX-License-Identifier: GPL-3.0-or-later
// A new order of elimination at each split.
#pragma once

#include "bench/methods/split_solver.hpp"

namespace rhexis::bench {

/// In single precision, by the kernel's own factor: the better of two orders.
std::unique_ptr<SplitSolver> anew_in_single();
/// In double precision, by CHOLMOD: minimum degree.
std::unique_ptr<SplitSolver> anew_in_double();

}  // namespace rhexis::bench
