// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

/// "lens_chart": speed against accuracy of the ways to advance the lens.
std::vector<BenchCase> lens_chart_cases();

}  // namespace rhexis::bench
