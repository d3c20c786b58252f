// SPDX-License-Identifier: GPL-3.0-or-later
// Peak memory of whole runs, in processes of their own.
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> memory_cases();

}  // namespace rhexis::bench
