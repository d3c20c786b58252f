// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes of a patient's eye.
#pragma once

#include "flow/eye_model.hpp"
#include "mesh/half_ellipsoids.hpp"

namespace rhexis {

/// Contour of the lens. Thickness 2.93 + 0.024 age [Dubbelman2001] (4.56 mm at 68 years; cataract eyes measure
/// 4.52 +- 0.45, [BmcBiometry2021]); diameter 8.70 + 0.0138 age and anterior : posterior thickness 0.70 : 1
/// [Rosen2006].
HalfEllipsoids lens_shape(const Patient& patient);

/// Cornea, limbus, iris and wound around that lens: means of 28,709 cataract eyes [BmcBiometry2021], the depth of the
/// anterior chamber with its regression on age. The iris plane lies just in front of the lens at the edge of the pupil.
EyeAnatomy make_anatomy(const Patient& patient);

/// z >= 0 or <= 0 half of a shape's surface at distance rho <= radius from the axis [mm].
double anterior_z(const HalfEllipsoids& shape, double rho);
double posterior_z(const HalfEllipsoids& shape, double rho);

}  // namespace rhexis
