// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture costs, and how exact the optical depth of the lens is.
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> render_cases();

}  // namespace rhexis::bench
