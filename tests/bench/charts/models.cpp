// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/charts/models.hpp"

namespace rhexis::bench {

std::vector<Chart> charts() { return {chart_chamber()}; }

}  // namespace rhexis::bench
