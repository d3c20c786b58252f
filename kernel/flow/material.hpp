// SPDX-License-Identifier: GPL-3.0-or-later
// What a tissue is made of.
#pragma once

#include <string>

#include "math/types.hpp"

namespace rhexis {

struct Material {
    std::string name;                ///< "nucleus", "cortex", ...
    double young_modulus = 1000.0;   ///< [Pa], > 0
    double poisson_ratio = 0.45;     ///< [-], in [0, 0.499]
    double density = 1.05e-3;        ///< [g/mm^3], > 0
    double ablation_energy = 0.0;    ///< ultrasound energy to emulsify it [mJ/mm^3]; 0: cannot be emulsified
    double toughness = 0.0;          ///< energy per area of crack [uN/mm], that is mJ/m^2; 0: it cannot crack
    Vec3 extinction = Vec3::Zero();  ///< Beer-Lambert attenuation for red, green, blue [1/mm]
};

}  // namespace rhexis
