// SPDX-License-Identifier: GPL-3.0-or-later
// A marker body to be printed: what carries its spheres, with the instrument's own shape or to be put on a real one.
#pragma once

#include <optional>
#include <string>

#include "base/result.hpp"
#include "tracking/bodies/mount.hpp"
#include "tracking/print/solid.hpp"

namespace rhexis::tracking {

/// Sizes [mm]; each within what its comment says.
struct MarkerBodyPrint {
    MountSizes mount{};
    double pin_radius = 1.0;  ///< of the pin that a sphere is put on; 0.2 to 5, less than the strut's
    double pin_length = 2.0;  ///< above the seat; 0.5 to 10, at most the spheres' radius
};

/// What spheres are fixed to, in the instrument's frame, its tip at the origin.
struct Replica {
    std::optional<Handle> handle{};  ///< none: a plate below the markers, across the body's z axis
    std::vector<Solid> shape{};      ///< closed shells, printed in one with what carries the spheres; empty: a sleeve
                                     ///< with a bore to be put on an instrument that is there
};

/// A binary STL file, in the body's frame [mm]: the shape where MarkerBody::tip has it, a sleeve about its handle
/// (where the handle ends too early a rod goes on from it), and for each sphere a strut whose end is hollowed to the
/// sphere's radius and the clearance, with a pin. All are closed shells, normals outwards, that overlap: slicers join
/// them. The error: a size out of its range, or no room for a strut (the marker is named).
Result<std::string> marker_body_stl(const MarkerBody& body, const Replica& replica, const MarkerBodyPrint& print = {});

}  // namespace rhexis::tracking
