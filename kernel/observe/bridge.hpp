// SPDX-License-Identifier: GPL-3.0-or-later
// What still holds the two halves of a nucleus together that a groove divides.
#pragma once

#include "observe/groove_shape.hpp"

namespace rhexis {

struct Bridge {
    double area = 0.0;          ///< [mm^2]
    Vec3 place = Vec3::Zero();  ///< its middle, at rest [mm]
};

/// Least area of nucleus that has to give way before what lies beyond 1.2 mm on one side of a groove is apart from what
/// lies beyond it on the other. Faces that have broken and tissue that is gone hold nothing. At rest.
Bridge find_bridge(const SolidModel& lens, const SolidState& state, const GrooveShape& groove);

/// Area of the whole nucleus in the upright plane through a groove [mm^2].
double section_area(const SolidModel& lens, const ColumnGrid& grid, const GrooveShape& groove);

}  // namespace rhexis
