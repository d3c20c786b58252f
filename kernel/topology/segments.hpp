// SPDX-License-Identifier: GPL-3.0-or-later
// A nucleus that a laser has cut into segments before the operation.
#pragma once

#include <vector>

#include "flow/mesh_edit.hpp"
#include "flow/solid.hpp"

namespace rhexis {

/// Faces between tetrahedra on either side of planes through the axis, ascending: 2, 4, 6 or 8 equal segments. The cuts
/// follow the mesh: within the size of a tetrahedron of the planes. Other counts: none.
std::vector<BrokenFace> segment_faces(const SolidModel& model, int segments);

}  // namespace rhexis
