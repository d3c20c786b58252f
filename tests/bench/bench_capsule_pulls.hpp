// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> capsule_pulls_cases();

}  // namespace rhexis::bench
