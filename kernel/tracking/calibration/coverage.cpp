// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/coverage.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::tracking {

double Coverage::share() const {
    const auto filled = std::count_if(points.begin(), points.end(), [](int count) { return count > 0; });
    return points.empty() ? 0.0 : static_cast<double>(filled) / static_cast<double>(points.size());
}

Coverage coverage_of(std::span<const Vec2> points, int width, int height) {
    Coverage coverage;
    coverage.points.assign(static_cast<std::size_t>(coverage.columns * coverage.rows), 0);
    for (const Vec2& point : points) {
        const int column = static_cast<int>(std::floor((point.x() + 0.5) * coverage.columns / width));
        const int row = static_cast<int>(std::floor((point.y() + 0.5) * coverage.rows / height));
        if (column >= 0 && column < coverage.columns && row >= 0 && row < coverage.rows) {
            ++coverage.points[static_cast<std::size_t>(row * coverage.columns + column)];
        }
    }
    return coverage;
}

}  // namespace rhexis::tracking
