// SPDX-License-Identifier: GPL-3.0-or-later
// topology -> session: a change of a membrane's connectivity as a value, applied once.
#pragma once

#include <array>
#include <vector>

#include "flow/membrane.hpp"

namespace rhexis {

/// A new node at a + share (b - a), at rest and now. A copy of a: share 0.
struct SheetNode {
    int a = 0;
    int b = 0;
    double share = 0.0;
};

/// A triangle gets other nodes, or a new one is added at the end of the list.
struct SheetTriangle {
    int triangle = -1;  ///< that changes; -1: new
    std::array<int, 3> nodes{};
    int parent = 0;  ///< triangle before the edit whose fibre, thickness and stiffness it has
};

struct MembraneEdit {
    std::vector<SheetNode> nodes;          ///< in the order of their numbers
    std::vector<SheetTriangle> triangles;  ///< changed ones ascending, then new ones
    std::vector<int> out;                  ///< triangles that are taken out, ascending; nothing else changes then
    std::vector<TearTip> tips;             ///< all of them, after the edit
    double torn_area = 0.0;                ///< that it opens: length times thickness [mm^2]
    double torn_energy = 0.0;              ///< that it takes [nJ]
    double edge_out = 0.0;                 ///< length at rest of the edges of what is taken out [mm]
    double area_out = 0.0;                 ///< its area at rest [mm^2]
};

}  // namespace rhexis
