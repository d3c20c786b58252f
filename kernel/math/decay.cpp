// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/decay.hpp"

#include <cmath>

#include "base/assert.hpp"

namespace rhexis {

/// The series of the mean for a short time, whose terms fall by more than 8 each, then that time doubled.
Decay decay(double x) {
    RHEXIS_ASSERT(x >= 0.0);
    if (x > 745.0) {
        return {0.0, 1.0 / x};
    }
    int doublings = 0;
    double part = x;
    for (; part > 0.125; part *= 0.5) {
        ++doublings;
    }
    double mean = 1.0;
    for (int k = 12; k >= 2; --k) {
        mean = 1.0 - part / k * mean;
    }
    double left = 1.0 - part * mean;
    for (int i = 0; i < doublings; ++i) {
        mean *= 0.5 * (1.0 + left);
        left *= left;
    }
    return {left, mean};
}

}  // namespace rhexis
