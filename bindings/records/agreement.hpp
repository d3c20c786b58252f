// SPDX-License-Identifier: GPL-3.0-or-later
// How far judges agree: intraclass correlation and limits of agreement.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rhexis::records {

/// Scores of n targets by k judges, one row per target.
using Scores = std::vector<std::vector<double>>;

struct Correlation {
    std::size_t targets = 0;
    std::size_t judges = 0;
    double single = 0.0;   ///< ICC(2,1): one judge of many, absolute agreement
    double average = 0.0;  ///< ICC(2,k): the mean of these k judges
};

/// Two-way random effects [ShroutFleiss1979]. None, with the reason in `why`, for fewer than two targets or judges, and
/// where nobody's scores vary at all. Rows are all of the same length.
std::optional<Correlation> intraclass(const Scores& scores, std::string& why);

struct Limits {
    std::size_t n = 0;
    double bias = 0.0;  ///< mean of a - b
    double sd = 0.0;    ///< of a - b, with n - 1
    double low = 0.0;   ///< bias - 1.96 sd
    double high = 0.0;
};

/// Limits within which 95 % of the differences lie if they are normal [BlandAltman1986]. None for fewer than two pairs.
std::optional<Limits> limits_of_agreement(std::span<const double> a, std::span<const double> b);

}  // namespace rhexis::records
