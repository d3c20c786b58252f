// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks of the implicit step on the reference lenses.
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> implicit_cases();

}  // namespace rhexis::bench
