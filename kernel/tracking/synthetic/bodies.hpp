// SPDX-License-Identifier: GPL-3.0-or-later
// Marker bodies to try tracking with.
#pragma once

#include <vector>

#include "tracking/marker_body.hpp"

namespace rhexis::tracking::synthetic {

/// "head", "phaco", "capsulorhexis_forceps" and "chopper", four markers each; the origin is the markers' centre. All
/// 24 distances between markers of a body differ by 2 mm or more. An instrument's axis is its z axis, its tip 80 to
/// 115 mm before the markers, which stand off its handle; the head's tip is the eye, 95 mm from its markers.
std::vector<MarkerBody> standard_bodies();

}  // namespace rhexis::tracking::synthetic
