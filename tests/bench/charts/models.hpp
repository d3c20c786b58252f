// SPDX-License-Identifier: GPL-3.0-or-later
// One chart for each model, a file each: charts/chart_NAME.cpp.
#pragma once

#include "bench/chart.hpp"

namespace rhexis::bench {

Chart chart_chamber();

}  // namespace rhexis::bench
