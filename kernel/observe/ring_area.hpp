// SPDX-License-Identifier: GPL-3.0-or-later
// The area of a closed polygon.
#pragma once

#include <vector>

namespace rhexis {

/// As seen along z, positive against the clock. Point: with x() and y(); the last is beside the first.
template <typename Point>
double ring_area(const std::vector<Point>& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& a = ring[i];
        const Point& b = ring[(i + 1) % ring.size()];
        sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return sum;
}

}  // namespace rhexis
