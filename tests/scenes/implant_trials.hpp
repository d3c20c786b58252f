// SPDX-License-Identifier: GPL-3.0-or-later
// Provocation of an implant in its bag, short as a test and long as a benchmark. It returns what it measured; the gates
// stand where it is called.
#pragma once

#include "math/types.hpp"

namespace rhexis::scenes {

struct Settling {
    double deepest = 0.0;        ///< penetration over the implant's thickness
    double residual = 0.0;       ///< largest that was kept, of the forces of contact
    double rough = 0.0;          ///< share of the steps that were kept without being balanced
    double speed = 0.0;          ///< of its fastest node at the end [mm/s]
    Vec3 middle = Vec3::Zero();  ///< of its nodes at the end [mm]
    int failures = 0;            ///< steps that no way could solve
    bool finite = true;
};
/// T26: a folded implant is pushed into a bag in steps of dt [s], and looked at for so many seconds after.
Settling settle_in_bag(double dt, double seconds);

}  // namespace rhexis::scenes
