// SPDX-License-Identifier: GPL-3.0-or-later
// How far a round opening of the capsule springs open when it is cut at once, as a laser cuts it: what pulls on the
// uncut capsule tells of itself so. Published for eyes that are operated on [Tan2025].
#pragma once

#include "eye/anterior_capsule.hpp"

namespace rhexis::scenes {

struct Retraction {
    double cut = 0.0;     ///< diameter of the cut while the capsule is whole, as seen along the axis [mm]
    double open = 0.0;    ///< of the opening once sheet and lens are at rest, likewise [mm]
    double rest = 0.0;    ///< of the opening in the sheet without tension [mm]
    bool closed = false;  ///< the cut met its beginning
};

/// A circle about the axis in a full chamber, cut along the mesh. diameter: as seen while the capsule is whole [mm].
Retraction retraction(double age, double diameter, const AnteriorCapsuleSettings& settings = {});

}  // namespace rhexis::scenes
