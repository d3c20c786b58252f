// SPDX-License-Identifier: GPL-3.0-or-later
// Inside mesh: moves nodes so that tetrahedra become well shaped, without changing what they connect.
#pragma once

#include "mesh/half_ellipsoids.hpp"
#include "mesh/stuffing.hpp"

namespace rhexis {

/// Lowers the sum over tetrahedra of (mean squared edge / volume^(2/3))^6 / volume^2, a barrier against slivers and
/// small elements, by moving one node at a time; surface nodes slide on the shape. Never lets a tetrahedron invert.
void smooth(const HalfEllipsoids& shape, int sweeps, StuffedSolid& solid);

}  // namespace rhexis
