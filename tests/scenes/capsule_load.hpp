// SPDX-License-Identifier: GPL-3.0-or-later
// What pulls on a capsule before anything is cut.
#pragma once

#include "scenes/capsule_scene.hpp"

namespace rhexis::scenes {

struct CapsuleLoad {
    double lift = 0.0;              ///< of the lens, forward from where it rests [mm]
    double zonules = 0.0;           ///< sum of what the springs in place of the zonules pull with [uN]
    double tension_radial = 0.0;    ///< mean over a ring of the capsule, 2.3 to 2.9 mm from the axis [uN/mm]
    double tension_circular = 0.0;  ///< likewise
    double energy = 0.0;            ///< elastic, of all of the sheet [nJ]
};

CapsuleLoad capsule_load(const MembraneModel& model, const MembraneState& sheet);

}  // namespace rhexis::scenes
