// SPDX-License-Identifier: GPL-3.0-or-later
// Of an instrument, the triangles that lie in the eye, or outside of it.
#pragma once

#include <vector>

#include "flow/frame.hpp"
#include "render/tool_mesh.hpp"

namespace rhexis {

/// Which side of the eye's wall to draw.
enum class Medium { all = 0, inside = 1, outside = 2 };

/// Appends the corners as vertices (place in the tool's frame and normal, 3 floats each) of all triangles that may
/// reach into a medium: what surely lies in the other one is left out, long triangles are split for that. pose: of the
/// part.
void append_triangles_in(Medium medium, const EyeAnatomy& eye, const Pose& pose, const ToolMesh::Part& part,
                         std::vector<float>& stream);

}  // namespace rhexis
