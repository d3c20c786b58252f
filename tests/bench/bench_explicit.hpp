// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks of the explicit way to advance a solid, and of the product that speeds are quoted in.
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> explicit_cases();

}  // namespace rhexis::bench
