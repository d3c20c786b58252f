// SPDX-License-Identifier: GPL-3.0-or-later
// What counts of attempts say about the shares behind them.
#pragma once

namespace rhexis::scenes {

struct Interval {
    double low = 0.0;
    double high = 0.0;
};

/// Of a share, at 95 % [Wilson1927]. of > 0.
Interval wilson(int count, int of);

/// Fisher's exact test, two-sided: how likely two groups of the same share differ as much or more [Fisher1922].
double fisher(int count_a, int of_a, int count_b, int of_b);

}  // namespace rhexis::scenes
