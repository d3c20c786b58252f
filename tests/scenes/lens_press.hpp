// SPDX-License-Identifier: GPL-3.0-or-later
// What a trainee's hand feels: the default patient's lens, its posterior surface held, pressed at the anterior pole by
// a ball, and the same lens lying in its bag under the phaco tip.
#pragma once

#include <vector>

#include "scenes/lens_poke.hpp"

namespace rhexis::scenes {

/// The tool's force and the dip of the surface under it, means of windows of 10 ms.
struct LensPress {
    std::vector<double> force;  ///< [uN]
    std::vector<double> dip;    ///< at the end of the window [mm]
    double cpu_s_per_s = 0.0;
    int rollbacks = 0;
};

/// A ball of 1 mm radius comes down 0.4 mm within 0.2 s and stays for 0.2 s, in steps of dt [s] (a divisor of 10 ms).
LensPress press_lens(SolidModel lens, double dt);

/// CPU seconds per simulated second of the physics alone while a phaco tip strokes over the lens in its bag, pressed
/// 0.1 mm into it, at 3.5 mm/s, without ultrasound; grade of the nucleus 1 to 6.
double stroke_cost(const SolidModel& lens, double grade);

/// Root mean square difference of two series over that of the second.
double relative_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace rhexis::scenes
