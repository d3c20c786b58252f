// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/rank_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rhexis::cli {
namespace {

constexpr std::size_t most_exact = 20;

/// Pairs of which the first is greater, a tie counting one half.
double pairs_won(std::span<const double> a, std::span<const double> b) {
    double won = 0.0;
    for (const double x : a) {
        for (const double y : b) {
            won += x > y ? 1.0 : x == y ? 0.5 : 0.0;
        }
    }
    return won;
}

std::vector<double> sorted_together(std::span<const double> a, std::span<const double> b) {
    std::vector<double> all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    std::sort(all.begin(), all.end());
    return all;
}

/// Sum over groups of t equal values of t^3 - t.
double tie_sum(const std::vector<double>& sorted) {
    double sum = 0.0;
    for (std::size_t from = 0; from < sorted.size();) {
        std::size_t to = from;
        while (to < sorted.size() && sorted[to] == sorted[from]) {
            ++to;
        }
        const auto t = static_cast<double>(to - from);
        sum += t * t * t - t;
        from = to;
    }
    return sum;
}

/// Share of all orders of m and n values without ties in which U is at most u: counts[k] is the number of orders with
/// U = k, by adding one value of the first sample after the other.
double share_up_to(std::size_t m, std::size_t n, std::size_t u) {
    // ways[j][k]: choices of j of the first ranks whose U is k
    std::vector<std::vector<double>> ways(m + 1, std::vector<double>(m * n + 1, 0.0));
    ways[0][0] = 1.0;
    for (std::size_t rank = 0; rank < m + n; ++rank) {
        for (std::size_t j = std::min(m, rank + 1); j >= 1; --j) {
            const std::size_t below = rank - (j - 1);  // values of the other sample below this one
            for (std::size_t k = m * n + 1; k-- > below && below <= n;) {
                ways[j][k] += ways[j - 1][k - below];
            }
        }
    }
    double all = 0.0;
    double up_to = 0.0;
    for (std::size_t k = 0; k <= m * n; ++k) {
        all += ways[m][k];
        up_to += k <= u ? ways[m][k] : 0.0;
    }
    return up_to / all;
}

}  // namespace

double mean_of(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double deviation_of(std::span<const double> values) {
    if (values.size() < 2) {
        return 0.0;
    }
    const double mean = mean_of(values);
    double sum = 0.0;
    for (const double value : values) {
        sum += (value - mean) * (value - mean);
    }
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double correlation_of(std::span<const double> a, std::span<const double> b) {
    const double spread = deviation_of(a) * deviation_of(b);
    if (a.size() != b.size() || !(spread > 0.0)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double mean_a = mean_of(a);
    const double mean_b = mean_of(b);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] - mean_a) * (b[i] - mean_b);
    }
    return sum / (static_cast<double>(a.size() - 1) * spread);
}

RankTest mann_whitney(std::span<const double> a, std::span<const double> b) {
    if (a.empty() || b.empty()) {
        return {};
    }
    const auto m = static_cast<double>(a.size());
    const auto n = static_cast<double>(b.size());
    const double won = pairs_won(a, b);
    RankTest test;
    test.u = std::min(won, m * n - won);
    const double ties = tie_sum(sorted_together(a, b));
    test.exact = ties == 0.0 && std::max(a.size(), b.size()) <= most_exact;
    if (test.exact) {
        const auto u = static_cast<std::size_t>(std::lround(test.u));
        test.p = std::min(1.0, 2.0 * share_up_to(a.size(), b.size(), u));
        return test;
    }
    const double total = m + n;
    const double variance = m * n / 12.0 * (total + 1.0 - ties / (total * (total - 1.0)));
    if (!(variance > 0.0)) {
        return test;
    }
    // half a step is taken off for U moves in steps
    const double z = std::max(0.0, std::abs(won - m * n / 2.0) - 0.5) / std::sqrt(variance);
    test.p = std::min(1.0, std::erfc(z / std::sqrt(2.0)));
    return test;
}

}  // namespace rhexis::cli
