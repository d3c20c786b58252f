// SPDX-License-Identifier: GPL-3.0-or-later
// Paired timing on a machine that others use too: the candidates take turns, and each reports its fastest turn.
#pragma once

#include <functional>
#include <vector>

namespace rhexis::bench {

struct Timing {
    double seconds = 0.0;  ///< thread CPU time of one call, fastest turn
    double spread = 0.0;   ///< (median - fastest) / fastest over the turns
};

/// Runs every function in turn (A B C A B C ...), `repeats` turns each, each turn long enough to be timed
/// (about `turn_seconds`). One untimed turn first.
std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& functions, int repeats,
                                     double turn_seconds = 5e-3);

}  // namespace rhexis::bench
