// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

/// "calculix": the poked lens in CalculiX and here, by mesh.
std::vector<BenchCase> calculix_cases();

}  // namespace rhexis::bench
