// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> capsule_chart_cases();

}  // namespace rhexis::bench
