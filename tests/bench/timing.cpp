// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/timing.hpp"

#include <algorithm>
#include <cstddef>

#include "base/clock.hpp"

namespace rhexis::bench {
namespace {

double turn(const std::function<void()>& function, int calls) {
    const double start = thread_cpu_seconds();
    for (int k = 0; k < calls; ++k) {
        function();
    }
    return (thread_cpu_seconds() - start) / calls;
}

int calls_for(const std::function<void()>& function, double turn_seconds) {
    const double once = std::max(turn(function, 1), 1e-9);
    const double warm =
        std::max(turn(function, std::clamp(static_cast<int>(0.2 * turn_seconds / once), 1, 1000)), 1e-9);
    return std::clamp(static_cast<int>(turn_seconds / warm), 1, 1000000);
}

}  // namespace

std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& functions, int repeats,
                                     double turn_seconds) {
    std::vector<int> calls;
    for (const std::function<void()>& function : functions) {
        calls.push_back(calls_for(function, turn_seconds));
    }
    std::vector<std::vector<double>> seconds(functions.size());
    for (int r = 0; r < repeats; ++r) {
        for (std::size_t f = 0; f < functions.size(); ++f) {
            seconds[f].push_back(turn(functions[f], calls[f]));
        }
    }
    std::vector<Timing> result;
    for (std::vector<double>& turns : seconds) {
        std::sort(turns.begin(), turns.end());
        result.push_back({turns.front(), (turns[turns.size() / 2] - turns.front()) / turns.front()});
    }
    return result;
}

}  // namespace rhexis::bench
