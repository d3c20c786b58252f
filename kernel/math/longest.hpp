// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/types.hpp"

namespace rhexis {

/// Length of the longest vector; 0 of none.
inline double longest(const std::vector<Vec3>& vectors) {
    double square = 0.0;
    for (const Vec3& v : vectors) {
        square = std::max(square, v.squaredNorm());
    }
    return std::sqrt(square);
}

}  // namespace rhexis
