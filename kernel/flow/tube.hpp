// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid tube that a shell is pushed through, such as the cartridge of an injector.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/bag.hpp"
#include "math/types.hpp"

namespace rhexis {

/// The bore at a place along the axis: an ellipse.
struct TubeStation {
    double z = 0.0;            ///< along the axis [mm]
    double half_width = 1.0;   ///< along the tube's x [mm], 0.01 to 100
    double half_height = 1.0;  ///< along its y [mm], likewise
};

/// Axis z of its own frame; what is pushed through goes to +z and leaves at the last station. The bore goes over
/// smoothly from station to station and goes on without end before the first.
struct TubeModel {
    std::string name = "tube";
    Pose pose;
    std::vector<TubeStation> stations{{0.0, 1.0, 1.0}, {10.0, 1.0, 1.0}};  ///< by ascending z, one or more
    double lip = 0.1;       ///< half of the wall, which ends round at the open end [mm], 0.001 to 10
    double friction = 0.1;  ///< Coulomb coefficient, 0 to 10
};

/// Fails with the field and what is allowed.
Status check_tube(const TubeModel& tube);

/// Whether a point in the tube's frame is in the bore, before its end.
bool within_bore(const TubeModel& tube, const Vec3& point);

/// Distance of a point in the tube's frame from the wall, positive in the bore, before the end and beside the tube, and
/// the unit normal away from the wall, from the side of its middle that the point is on. Exact where the bore is round
/// and straight or a cone; elsewhere the distance in the plane across the axis times the cosine of the wall's slope.
SurfaceDistance tube_distance(const TubeModel& tube, const Vec3& point);

}  // namespace rhexis
