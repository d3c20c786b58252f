// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of a solid, as both ways to advance it see it: stiffness per tetrahedron, inertia and weight per node.
#pragma once

#include <vector>

#include "flow/solid.hpp"

namespace rhexis {

/// Stiffness and load-bearing share of every coarse tetrahedron; share 0 where it is gone.
std::vector<TetStiffness> tet_stiffness(const SolidModel& model, const SolidState& state);

/// Per coarse node, a quarter of each of its tetrahedra.
struct NodeMass {
    std::vector<double> inertia;  ///< resists acceleration, floored like the stiffness [g]
    std::vector<double> weight;   ///< what gravity acts on: mass left, less the fluid it displaces; may be negative [g]
};
NodeMass node_mass(const SolidModel& model, const SolidState& state, const std::vector<TetStiffness>& stiffness);

}  // namespace rhexis
