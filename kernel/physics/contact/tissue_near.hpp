// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the fine tetrahedra that lie close to the working end of a tool.
#pragma once

#include <array>
#include <vector>

#include "flow/solid.hpp"
#include "flow/tool.hpp"

namespace rhexis {

struct FineTissue {
    int tet = 0;                  ///< fine tetrahedron, of which something is left
    std::array<Vec3, 4> corners;  ///< where they are now [mm]
};

/// Those whose coarse tetrahedron may come within `reach` [mm] of the end of a tool at `pose`, ascending.
std::vector<FineTissue> tissue_near(const SolidModel& model, const SolidState& state, const RoundedCone& end,
                                    const Pose& pose, double reach);

/// Whether a point lies in a tetrahedron, its faces included.
bool holds(const std::array<Vec3, 4>& corners, const Vec3& point);

}  // namespace rhexis
