// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/table.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"

namespace rhexis {

namespace {

/// a (b / a)^share by repeated square roots: exactly rounded operations only, unlike the library's pow, whose last bit
/// depends on the processor.
double geometric_mean(double a, double b, double share) {
    double root = b / a;
    double result = a;
    for (int bit = 0; bit < 52 && share > 0.0; ++bit) {
        root = std::sqrt(root);
        share *= 2.0;
        if (share >= 1.0) {
            result *= root;
            share -= 1.0;
        }
    }
    return result;
}

template <typename Mean>
double between(std::span<const TableRow> rows, double at, const Mean& mean) {
    RHEXIS_ASSERT(!rows.empty());
    const auto above = std::find_if(rows.begin(), rows.end(), [at](const TableRow& row) { return row.at >= at; });
    if (above == rows.begin()) {
        return rows.front().value;
    }
    if (above == rows.end()) {
        return rows.back().value;
    }
    const TableRow& low = *(above - 1);
    return at == above->at ? above->value : mean(low.value, above->value, (at - low.at) / (above->at - low.at));
}

}  // namespace

double linear_between(std::span<const TableRow> rows, double at) {
    return between(rows, at, [](double a, double b, double share) { return a + share * (b - a); });
}

double geometric_between(std::span<const TableRow> rows, double at) { return between(rows, at, geometric_mean); }

}  // namespace rhexis
