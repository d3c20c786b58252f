// SPDX-License-Identifier: GPL-3.0-or-later
// What carries a body's spheres on a handle: a sleeve about it, and a strut from the sleeve to each sphere.
#pragma once

#include <vector>

#include "base/result.hpp"
#include "tracking/bodies/handle.hpp"
#include "tracking/marker_body.hpp"

namespace rhexis::tracking {

/// Sizes [mm]; each within what its comment says.
struct MountSizes {
    double clearance = 0.1;      ///< between sleeve and handle, and between seat and sphere; 0 to 1
    double wall = 3.0;           ///< of the sleeve; 1 to 10
    double least_width = 8.0;    ///< of the sleeve along the handle; 2 to 50
    double strut_radius = 2.0;   ///< 1.2 to 7, and at most 0.9 of the spheres' radius
    double apart = 0.5;          ///< from a strut to what it is not to meet; 0 to 5
    double hand_mm = 40.0;       ///< the sleeve begins at least so far behind the tip, for fingers; 0 to 200
    double least_end_mm = 75.0;  ///< where a handle that ends before it goes on as a rod; 0 to 300
    double rod_radius = 2.0;     ///< of such a rod; 1 to 10
};

struct Mount {
    double from_mm = 0.0;  ///< of the sleeve, behind the tip along the handle's axis
    double to_mm = 0.0;
    double bore = 0.0;           ///< radius of the handle within it, without clearance
    std::vector<Vec3> begins{};  ///< middle of each strut's round end at the sleeve, by marker
};

/// handle: in the body's frame. Struts begin where they are short and near to one another, and clear of other spheres
/// and of the instrument. The error names the marker for which there is no such place, or that is too near to the
/// handle.
Result<Mount> mount_of(const MarkerBody& body, const Handle& handle, const MountSizes& sizes = {});

}  // namespace rhexis::tracking
