// SPDX-License-Identifier: GPL-3.0-or-later
// What is tracked: a few reflecting spheres fixed to a replica of an instrument, or to the mannequin's head. The
// distances between them are its signature.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "math/types.hpp"

namespace rhexis::tracking {

struct MarkerBody {
    std::string name{};           ///< the instrument's, or "head"
    std::vector<Vec3> markers{};  ///< centres, in the body's frame [mm]; 3 to 8
    double radius_mm = 3.0;       ///< of each
    Pose tip{};  ///< the instrument's tip in the body's frame; its +z points from the tip along the shaft to the hand
};

/// Bodies that cannot be mistaken for one another, nor for their own mirror images, however they are turned: any two
/// distances, within a body and between bodies, differ by `apart_mm`; a body of four does not lie in a plane, and one
/// of three, which has a mirror image of itself by turning it over, has no two sides alike. The error names bodies,
/// markers and distances.
Status check_signatures(std::span<const MarkerBody> bodies, double apart_mm = 2.0);

}  // namespace rhexis::tracking
