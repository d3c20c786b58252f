// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/roots.hpp"

#include <algorithm>

namespace rhexis {

/// Newton's method from above comes down without overshooting.
double cube_root(double x) {
    if (!(x > 0.0)) {
        return 0.0;
    }
    double root = std::max(1.0, x);
    for (int i = 0; i < 1200; ++i) {
        const double next = (2.0 * root + x / (root * root)) / 3.0;
        if (!(next < root)) {
            break;
        }
        root = next;
    }
    return root;
}

double ball_radius(double volume) { return cube_root(0.238732414637843 * volume); }  // 3 / (4 pi)

}  // namespace rhexis
