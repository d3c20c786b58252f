// SPDX-License-Identifier: GPL-3.0-or-later
// A nucleus that was cut into segments, and sculpted along the cuts, before the exercise begins.
#pragma once

#include <vector>

#include "flow/mesh_edit.hpp"
#include "flow/solid.hpp"

namespace rhexis {

/// Faces between tetrahedra on either side of planes through the axis, ascending: 2, 4, 6 or 8 equal segments. The cuts
/// follow the mesh: within the size of a tetrahedron of the planes. Other counts: none.
std::vector<BrokenFace> segment_faces(const SolidModel& model, int segments);

/// Trenches of this width [mm] along those cuts: fine tetrahedra whose middle lies in them go. Open to the front, as
/// wide as three quarters of the lens, down to the back of the nucleus (material 0).
MeshEdit trench(const SolidModel& model, const SolidState& state, int solid, int segments, double width);

}  // namespace rhexis
