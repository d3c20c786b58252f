// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

/// "bulk": what the change of volume is averaged over, by a poked lens and by bars that bend.
std::vector<BenchCase> bulk_cases();

}  // namespace rhexis::bench
