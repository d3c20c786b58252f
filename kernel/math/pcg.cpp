// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/pcg.hpp"

#include <array>

namespace rhexis {

double dot(std::span<const double> a, std::span<const double> b) {
    std::array<double, 8> sums{};
    const std::size_t whole = a.size() / 8 * 8;
    for (std::size_t i = 0; i < whole; i += 8) {
        for (std::size_t lane = 0; lane < 8; ++lane) {
            sums[lane] += a[i + lane] * b[i + lane];
        }
    }
    for (std::size_t i = whole; i < a.size(); ++i) {
        sums[i - whole] += a[i] * b[i];
    }
    return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

}  // namespace rhexis
