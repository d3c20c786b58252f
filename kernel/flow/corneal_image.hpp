// SPDX-License-Identifier: GPL-3.0-or-later
// The cornea as one refracting surface, paraxial: what lies behind it looks larger than it is.
#pragma once

#include "flow/eye_model.hpp"

namespace rhexis {

inline constexpr double index_of_aqueous = 1.336;

/// (n - 1) / R [1/mm].
inline double corneal_power(const EyeAnatomy& eye) { return (index_of_aqueous - 1.0) / eye.cornea_radius; }

/// How many times as far from the axis something at height z [mm] looks as it is: n / (n - P d) at depth d behind the
/// cornea's front; 1 in front of it, and without a cornea.
inline double corneal_magnification(const EyeAnatomy& eye, double z) {
    const double depth = eye.cornea_apex_z - z;
    return eye.has_cornea && depth > 0.0 ? index_of_aqueous / (index_of_aqueous - corneal_power(eye) * depth) : 1.0;
}

}  // namespace rhexis
