// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the pull of surfaces that stick to each other, per area, against the gap between them. It rises from
// nothing to its greatest, the traction that parts them, at a third of its range and falls to nothing at its end:
//   pull(s) = 27/4 traction s (1 - s)^2,  s = gap / range in 0 to 1,
// a cohesive law with a potential. Parting takes 9/16 traction range per area.
#pragma once

namespace rhexis {

struct Tack {
    double traction = 0.0;  ///< [Pa], 0 or more; 0: nothing sticks
    double range = 0.02;    ///< [mm], above 0
};

/// At a gap; below 0 there is none.
struct TackPull {
    double energy = 0.0;  ///< [nJ/mm^2]; its derivative is the pull
    double pull = 0.0;    ///< together [Pa]
    double slope = 0.0;   ///< of the pull [Pa/mm]: negative beyond a third of the range
};

TackPull tack_at(const Tack& tack, double gap);

}  // namespace rhexis
