// SPDX-License-Identifier: GPL-3.0-or-later
// What of an instrument's shape is held in a hand: spheres stand about it.
#pragma once

#include <span>
#include <vector>

#include "base/result.hpp"
#include "flow/tool.hpp"

namespace rhexis::tracking {

/// The straight end of an instrument. Places on its axis are told by how far behind the tip they are, as the axis goes.
struct Handle {
    Vec3 foot = Vec3::Zero();        ///< of the tip on the axis [mm]
    Vec3 along = Vec3::UnitZ();      ///< unit, towards the hand
    double from_mm = 0.0;            ///< where it begins, behind the tip
    double to_mm = 0.0;              ///< where it ends
    std::vector<RoundedCone> on{};   ///< cones about the axis, of which it is made
    std::vector<RoundedCone> off{};  ///< the rest of the instrument

    [[nodiscard]] Vec3 at(double behind_mm) const { return foot + behind_mm * along; }
};

/// Of an instrument that lies within these cones, its tip at the origin: those in line with the one that ends farthest
/// from the tip. The error: no cones, or none that is longer than a millimetre. where: for it.
Result<Handle> handle_of(std::span<const RoundedCone> cones, const std::string& where);

/// The same handle, given in the frame in which its own frame is at `pose`.
Handle moved_to(const Pose& pose, Handle handle);

/// The greatest radius between two places of the axis; 0 where there is nothing of it. [mm]
double greatest_radius(const Handle& handle, double from_mm, double to_mm);

}  // namespace rhexis::tracking
