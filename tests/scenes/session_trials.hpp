// SPDX-License-Identifier: GPL-3.0-or-later
// Provocations of a session by what feeds it. Each returns what it measured; the gates stand where it is called.
#pragma once

#include "flow/solid.hpp"

namespace rhexis::scenes {

/// What goes wrong with the samples of a hand that sculpts at an even pace.
enum class Disturbance {
    none,
    missing,  ///< every second and third sample is lost
    spike,    ///< nothing for 200 ms, then the hand is where it has gone meanwhile
    pause,    ///< for 1 s the caller neither steps nor samples, while the hand goes on
};

struct Disturbed {
    int calls = 0;
    int steps = 0;          ///< executed: one for each call, whatever was missed
    int most_substeps = 0;  ///< of a step
    int rollbacks = 0;
    int failures = 0;           ///< steps that no way could solve
    double jump = 0.0;          ///< largest shift of the lens in a step [mm]
    double penetration = 0.0;   ///< deepest after any step [mm]
    Vec3 shift = Vec3::Zero();  ///< of the lens over the whole run [mm]
    double removed = 0.0;       ///< mass [g]
};
/// T22: 1.5 s of the default patient's lens of about 1,000 tetrahedra in its bag, sculpted by a phaco tip at 4 mm/s.
Disturbed disturb(Disturbance disturbance, Advance advance);

}  // namespace rhexis::scenes
