// SPDX-License-Identifier: GPL-3.0-or-later
// A marker body to be printed: a ring for the shaft, a bar, and a post with a seat and a pin for each sphere.
#pragma once

#include <string>

#include "base/result.hpp"
#include "tracking/marker_body.hpp"

namespace rhexis::tracking {

/// Sizes [mm]; each within what its comment says.
struct MarkerBodyPrint {
    double shaft_radius = 4.0;  ///< of what the ring slides onto; 0.5 to 50
    double clearance = 0.1;     ///< between ring and shaft, and between seat and sphere; 0 to 1
    double ring_width = 8.0;    ///< along the shaft; 2 to 50
    double ring_wall = 3.0;     ///< 1 to 10
    double bar_radius = 3.0;    ///< of the bar from the ring to where all posts begin; 1 to 10, at most the wall
    double post_radius = 2.0;   ///< 1.2 to 10, and at most 0.9 of the spheres' radius
    double pin_radius = 1.0;    ///< of the pin that a sphere is put on; 0.2 to 5, less than the post's
    double pin_length = 2.0;    ///< above the seat; 0.5 to 10, at most the spheres' radius
};

/// A binary STL file, in the body's frame [mm]. The ring lies about the axis of MarkerBody::tip, beside the markers'
/// mean; the bar leads from it to the mean, or just clear of the ring where the mean is nearer; a seat is hollowed to
/// the sphere's radius and the clearance, about the marker's centre. Ring, bar and posts are closed shells, normals
/// outwards, that overlap: slicers join them. The error: a size out of its range, or a post with no room for it, that
/// meets the shaft or another sphere (the markers are named).
Result<std::string> marker_body_stl(const MarkerBody& body, const MarkerBodyPrint& print = {});

}  // namespace rhexis::tracking
