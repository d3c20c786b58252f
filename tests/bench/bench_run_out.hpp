// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> run_out_cases();

}  // namespace rhexis::bench
