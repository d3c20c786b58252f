// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/agreement.hpp"

#include <cmath>
#include <numeric>

#include "base/assert.hpp"

namespace rhexis::records {
namespace {

/// Mean squares of the two-way analysis of variance without repetition.
struct MeanSquares {
    double targets = 0.0;  ///< BMS
    double judges = 0.0;   ///< JMS
    double error = 0.0;    ///< EMS
};

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

MeanSquares analyse(const Scores& scores) {
    const std::size_t n = scores.size();
    const std::size_t k = scores.front().size();
    std::vector<double> of_judge(k, 0.0);
    std::vector<double> of_target;
    for (const std::vector<double>& row : scores) {
        RHEXIS_ASSERT(row.size() == k);
        of_target.push_back(mean(row));
        for (std::size_t j = 0; j < k; ++j) {
            of_judge[j] += row[j] / static_cast<double>(n);
        }
    }
    const double all = mean(of_target);
    MeanSquares squares;
    for (std::size_t i = 0; i < n; ++i) {
        squares.targets += static_cast<double>(k) * (of_target[i] - all) * (of_target[i] - all);
        for (std::size_t j = 0; j < k; ++j) {
            const double rest = scores[i][j] - of_target[i] - of_judge[j] + all;
            squares.error += rest * rest;
        }
    }
    for (const double judge : of_judge) {
        squares.judges += static_cast<double>(n) * (judge - all) * (judge - all);
    }
    const double free_targets = static_cast<double>(n - 1);
    const double free_judges = static_cast<double>(k - 1);
    squares.targets /= free_targets;
    squares.judges /= free_judges;
    squares.error /= free_targets * free_judges;
    return squares;
}

bool all_the_same(const Scores& scores) {
    for (const std::vector<double>& row : scores) {
        for (const double score : row) {
            if (score != scores.front().front()) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

std::optional<Correlation> intraclass(const Scores& scores, std::string& why) {
    const std::size_t n = scores.size();
    const std::size_t k = n > 0 ? scores.front().size() : 0;
    if (n < 2) {
        why = n == 0 ? "nothing that all have scored" : "only one attempt that all have scored";
        return std::nullopt;
    }
    if (k < 2) {
        why = "too few judges";
        return std::nullopt;
    }
    if (all_the_same(scores)) {
        why = "all scores are the same";
        return std::nullopt;
    }
    const MeanSquares ms = analyse(scores);
    const double targets = static_cast<double>(n);
    const double judges = static_cast<double>(k);
    const double below_single = ms.targets + (judges - 1.0) * ms.error + judges * (ms.judges - ms.error) / targets;
    const double below_average = ms.targets + (ms.judges - ms.error) / targets;
    Correlation result;
    result.targets = n;
    result.judges = k;
    if (!(below_single > 0.0) || !(below_average > 0.0)) {  // the judges vary, and the targets less than chance
        why = "the attempts do not differ";
        return std::nullopt;
    }
    result.single = (ms.targets - ms.error) / below_single;
    result.average = (ms.targets - ms.error) / below_average;
    return result;
}

std::optional<Limits> limits_of_agreement(std::span<const double> a, std::span<const double> b) {
    RHEXIS_ASSERT(a.size() == b.size());
    if (a.size() < 2) {
        return std::nullopt;
    }
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i) {
        differences.push_back(a[i] - b[i]);
    }
    Limits limits;
    limits.n = a.size();
    limits.bias = mean(differences);
    double squares = 0.0;
    for (const double difference : differences) {
        squares += (difference - limits.bias) * (difference - limits.bias);
    }
    constexpr double normal_95 = 1.96;
    limits.sd = std::sqrt(squares / static_cast<double>(limits.n - 1));
    limits.low = limits.bias - normal_95 * limits.sd;
    limits.high = limits.bias + normal_95 * limits.sd;
    return limits;
}

}  // namespace rhexis::records
