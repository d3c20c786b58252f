// SPDX-License-Identifier: GPL-3.0-or-later
// The one helper that checks derivatives: central differences against the closed form.
#pragma once

#include <functional>

#include "math/types.hpp"

namespace rhexis::test {

/// Central differences of fourth order of a function of a vector; row i, column j is d f_i / d x_j.
inline MatX finite_difference(const std::function<VecX(const VecX&)>& function, const VecX& x, double step) {
    MatX result;
    for (Eigen::Index j = 0; j < x.size(); ++j) {
        const auto at = [&](double offset) {
            VecX moved = x;
            moved[j] += offset;
            return function(moved);
        };
        const VecX column = (8.0 * (at(step) - at(-step)) - (at(2.0 * step) - at(-2.0 * step))) / (12.0 * step);
        result.conservativeResize(column.size(), x.size());
        result.col(j) = column;
    }
    return result;
}

/// Largest entry of |closed_form - differences| relative to the largest entry of the closed form (or 1e-30).
inline double derivative_error(const std::function<VecX(const VecX&)>& function, const VecX& x, const MatX& closed_form,
                               double step) {
    const MatX difference = closed_form - finite_difference(function, x, step);
    return difference.cwiseAbs().maxCoeff() / (closed_form.cwiseAbs().maxCoeff() + 1e-30);
}

}  // namespace rhexis::test
