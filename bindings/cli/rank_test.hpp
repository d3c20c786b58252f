// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of small samples that a study reports.
#pragma once

#include <span>

namespace rhexis::cli {

double mean_of(std::span<const double> values);
/// Of a sample, with n - 1; 0 for fewer than two values.
double deviation_of(std::span<const double> values);
/// Pearson's correlation; not a number when either does not vary, or for fewer than two pairs.
double correlation_of(std::span<const double> a, std::span<const double> b);

struct RankTest {
    double u = 0.0;      ///< the smaller of the two U
    double p = 1.0;      ///< two-sided
    bool exact = false;  ///< from the distribution of U; false: from the normal one, with correction for ties
};

/// Mann and Whitney's U test [MannWhitney1947]. Exact up to 20 values each without ties. p is 1 where one is empty or
/// all values are the same.
RankTest mann_whitney(std::span<const double> a, std::span<const double> b);

}  // namespace rhexis::cli
