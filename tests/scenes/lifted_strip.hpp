// SPDX-License-Identifier: GPL-3.0-or-later
// A cantilever whose free end is lifted by a plane without friction: its force by the elastica.
#pragma once

#include "flow/world.hpp"

namespace rhexis::scenes {

/// A strip along x, clamped at 0. The plane is lower at the clamped end by `tilt` and touches the free end alone.
struct LiftedStrip {
    double length = 10.0;    ///< [mm]
    double width = 1.0;      ///< [mm]
    double thickness = 0.2;  ///< [mm]
    double lift = 0.1;       ///< of the plane above the flat strip's underside, where its free end was [mm]
    double tilt = 0.05;      ///< [rad], more than what the free end turns by

    [[nodiscard]] ShellModel model() const;
    /// At a share of the lift.
    [[nodiscard]] PlaneModel plane(double share) const;
    /// Of the plane on the strip, which does not stretch, along the plane's normal [uN].
    [[nodiscard]] double force() const;
};

}  // namespace rhexis::scenes
