// SPDX-License-Identifier: GPL-3.0-or-later
// What the lens is made of at a patient's age and grade of cataract.
#pragma once

#include <array>
#include <vector>

#include "flow/eye_model.hpp"
#include "mesh/half_ellipsoids.hpp"

namespace rhexis {

/// Regions of the lens, which index its materials. Their borders are scaled copies of the contour.
enum LensRegion { nucleus = 0, epinucleus = 1, cortex = 2 };

/// Size of the nucleus and of nucleus + epinucleus, as shares of the contour's. At 68 years the zones seen by
/// Scheimpflug photography leave a nucleus of 2.3 of 4.6 mm [Dubbelman2001]; the part that is hard in a cataract is
/// larger and grows with the grade. Proposal, not measured: 0.60 + 0.025 grade (3.1 mm thick, 6.5 mm wide at grade 3).
double nucleus_scale(const Patient& patient);
double epinucleus_scale(const Patient& patient);

/// Region of a point of the lens at rest.
int region_at(const Patient& patient, const HalfEllipsoids& shape, const Vec3& point);

/// Young's modulus of the nucleus [Pa]: the larger of the age rule, 1 kPa at 20 years to 5 kPa from 60 [Dequidt2013],
/// and the grade rule, NO2 2, NO3 5, NO4 12, NO5 30, NO6 80 kPa (proposal: no mapping of LOCS III grades is published).
double nucleus_modulus(const Patient& patient);

/// Materials of nucleus, epinucleus and cortex.
std::vector<Material> lens_materials(const Patient& patient);

/// The same tissues as light meets them from outside: cortex, epinucleus, nucleus.
std::array<LensZone, 3> lens_zones(const Patient& patient);

}  // namespace rhexis
