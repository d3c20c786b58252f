// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/proportions.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::scenes {
namespace {

double log_choose(int n, int k) { return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0); }

}  // namespace

Interval wilson(int count, int of) {
    constexpr double z = 1.959963984540054;
    const double n = of;
    const double share = count / n;
    const double middle = share + z * z / (2.0 * n);
    const double half = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
    const double scale = 1.0 + z * z / n;
    return {std::max(0.0, (middle - half) / scale), std::min(1.0, (middle + half) / scale)};
}

double fisher(int count_a, int of_a, int count_b, int of_b) {
    const int both = count_a + count_b;
    const auto chance = [&](int a) {
        return std::exp(log_choose(of_a, a) + log_choose(of_b, both - a) - log_choose(of_a + of_b, both));
    };
    const double seen = chance(count_a);
    double sum = 0.0;
    for (int a = std::max(0, both - of_b); a <= std::min(of_a, both); ++a) {
        const double one = chance(a);
        sum += one <= seen * (1.0 + 1e-9) ? one : 0.0;
    }
    return std::min(1.0, sum);
}

}  // namespace rhexis::scenes
