// SPDX-License-Identifier: GPL-3.0-or-later
// How a step of a membrane is solved.
#pragma once

namespace rhexis {

/// docs/tearing.md has the chart that chose these.
struct MembraneSolve {
    double force_tolerance = 20.0;  ///< force that may be left out of balance, > 0 [uN]
    int max_newton = 8;             ///< iterations of a substep, >= 1
    bool new_factors = true;        ///< one per iteration; or else one that is kept while that pays
};

}  // namespace rhexis
