// SPDX-License-Identifier: GPL-3.0-or-later
// Turning the nucleus in its bag: torque, load on the zonules and slip over the angle, by how much cortex still
// adheres.
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> rotation_cases();

}  // namespace rhexis::bench
