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
    Pose tip{};  ///< the instrument's frame in the body's: its origin is the tip; +z points from the tip along a
                 ///< straight shaft to the hand, and where a bent one's does in assets/instruments
};

/// Bodies of which no three markers can be taken for three others, of the same body or another, nor a body for its own
/// mirror image: any two distances within a body differ by `apart_mm`; of any three markers of one body and three of
/// another, set against each other in any order, some distance differs by as much; a body of four does not lie in a
/// plane. Three points of one body, each distance known to within e, then never fit other markers within a tolerance
/// below apart_mm - e. Points of several bodies together may fit by chance: the tracker asks their images as well. The
/// error names bodies, markers and distances.
Status check_signatures(std::span<const MarkerBody> bodies, double apart_mm = 2.0);

}  // namespace rhexis::tracking
