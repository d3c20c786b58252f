// SPDX-License-Identifier: GPL-3.0-or-later
// tools -> observe, render: the operating microscope that a foot moves over the eye.
#pragma once

#include "math/types.hpp"

namespace rhexis {

/// Its name among the instruments of a scene.
inline constexpr const char* microscope_name = "microscope";

/// Half the angle of the light that each eye gets from a point, as a sine. Proposal: a beam 12 mm wide at 200 mm.
inline constexpr double microscope_aperture = 0.03;

/// Constant while a scene runs.
struct MicroscopeModel {
    double field_radius = 7.3;  ///< of the round field, at the eye [mm]
    /// Within which all looks sharp, from end to end: 0.55 um / (2 A^2) + 0.34 mm / (A M) with the aperture A and a
    /// magnification M of 10 [Berek1927]. Uncertain: docs/picture.md [mm].
    double depth_of_field = 1.4;
    Vec3 start = Vec3::Zero();  ///< its position before the first step [mm]
};

struct MicroscopeState {
    /// What is in the middle of its field and in focus, in the eye's frame [mm]. It looks along -z. That the cornea
    /// changes depths in the eye by less than a tenth is left out.
    Vec3 position = Vec3::Zero();
};

}  // namespace rhexis
