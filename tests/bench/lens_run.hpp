// SPDX-License-Identifier: GPL-3.0-or-later
// The poked lens advanced in time by one method, for the chart: what it costs and how deep the load went.
#pragma once

#include <string>
#include <vector>

#include "scenes/lens_poke.hpp"

namespace rhexis::bench {

/// The load grows from 0 as (1 - cos(pi t / rise)) / 2 and is then held.
struct LoadHistory {
    double rise_s = 0.3;
    double end_s = 0.5;
    [[nodiscard]] double share(double time_s) const;
};

struct LensRun {
    double cpu_s_per_s = 0.0;   ///< CPU seconds of all threads per simulated second
    std::vector<double> depth;  ///< at multiples of 10 ms [mm]; empty: the method failed
    std::string failure;
};

LensRun run_explicit(const scenes::LensPoke& poke, double share_of_limit, const LoadHistory& history);
LensRun run_implicit(const scenes::LensPoke& poke, double step_s, int newton, double tolerance,
                     const LoadHistory& history);

/// Root mean square of depth against compliance * load, over the largest depth of the reference.
double depth_error(const LensRun& run, double compliance, double total_load, const LoadHistory& history);

}  // namespace rhexis::bench
