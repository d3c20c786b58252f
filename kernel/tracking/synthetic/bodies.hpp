// SPDX-License-Identifier: GPL-3.0-or-later
// Marker bodies that figures are measured with.
#pragma once

#include <vector>

#include "tracking/marker_body.hpp"

namespace rhexis::tracking::synthetic {

/// "head", "phaco", "forceps" and "chopper" of those that come with the program, four markers each; the origin is the
/// markers' centre. All 24 distances between markers of a body differ by 2 mm or more. An instrument's handle lies
/// along its z axis, and so does its tip's, 80 to 115 mm before the markers; the head's tip is the eye, 95 mm from its
/// markers.
std::vector<MarkerBody> standard_bodies();

}  // namespace rhexis::tracking::synthetic
