// SPDX-License-Identifier: GPL-3.0-or-later
// How long a pose is on its way from the server to who hears it, over real sockets of this computer.
#pragma once

#include "base/result.hpp"
#include "tracking/measure/figures.hpp"

namespace rhexis::tracking {

struct Hop {
    bool by_datagram = false;  ///< else by TCP
    int told = 0;
    int heard = 0;
    // From before the pose is handed to the server to after the client has handed it out [s].
    double median_s = 0.0;
    double of_99_s = 0.0;
    double worst_s = 0.0;
    double clocks_apart_s = 0.0;  ///< as is found from arrivals and stamps, of clocks that are the same
};

/// poses: so many, each a millisecond after the one before. Fails where no socket can be had.
Result<Hop> measure_hop(bool by_datagram, int poses);

/// Beside what was aimed at.
Figure figure_of(const Hop& hop);

}  // namespace rhexis::tracking
