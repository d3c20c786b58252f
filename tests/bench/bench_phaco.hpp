// SPDX-License-Identifier: GPL-3.0-or-later
// What accuracy of phacoemulsification costs: mesh level, step and method.
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> phaco_cases();

}  // namespace rhexis::bench
