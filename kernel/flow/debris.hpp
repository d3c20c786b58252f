// SPDX-License-Identifier: GPL-3.0-or-later
// A crumb of tissue that has come loose, too small for its shape to matter: a rigid ball.
#pragma once

#include "math/types.hpp"

namespace rhexis {

struct Debris {
    Vec3 position = Vec3::Zero();  ///< [mm]
    Vec3 velocity = Vec3::Zero();  ///< [mm/s]
    double volume = 0.0;           ///< [mm^3]
    double density = 1.05e-3;      ///< [g/mm^3]
    double ablation_energy = 0.0;  ///< ultrasound energy to emulsify it [mJ/mm^3]; 0: cannot be emulsified
};

/// Of a ball of that volume [mm].
double radius_of(const Debris& debris);

}  // namespace rhexis
