// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture's size and way of drawing cost, and how far it is off.
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> picture_cases();

}  // namespace rhexis::bench
