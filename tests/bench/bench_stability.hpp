// SPDX-License-Identifier: GPL-3.0-or-later
// Long versions of the stability gates.
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> stability_cases();

}  // namespace rhexis::bench
