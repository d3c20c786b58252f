// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments as triangles. What the light meets is what is drawn: the same triangles cast their depth into the lens.
#pragma once

#include <optional>
#include <vector>

#include "flow/tool.hpp"
#include "render/tool_shape.hpp"

namespace rhexis {

struct ToolMesh {
    struct Vertex {
        Vec3 place;   ///< in the tool's frame [mm]
        Vec3 normal;  ///< outward, unit
    };
    struct Part {
        ToolFinish finish = ToolFinish::steel;
        std::vector<Vertex> corners;   ///< three per triangle, counter-clockwise from outside
        std::optional<Hinge> hinge{};  ///< it turns as the jaws open
    };
    std::vector<Part> parts;          ///< opaque ones first
    std::vector<RoundedCone> bounds;  ///< closed, all of it lies within these, each as thick as its thicker end
};

/// Triangles of an instrument, of its shape (tool_shape.hpp) where it has one, else of what it touches with. The last
/// part goes on beyond its end, away from the tip, so that a shaft does not end in mid-air; a phaco tip is a hollow
/// needle cut at its bevel, opening to local +y, in a sleeve.
ToolMesh tool_mesh(const ToolModel& tool);
/// The same of a shape alone, of an instrument that nothing is touched with.
ToolMesh tool_mesh(const ToolShape& shape);

/// Where a part is, of an instrument in this state.
Pose pose_of(const ToolMesh::Part& part, const ToolState& tool);

/// The parts as they are drawn: the last one continued.
std::vector<RoundedCone> drawn_parts(const ToolModel& tool);

/// Appends the corners as vertices: place and normal, 3 floats each.
void append_triangles(const ToolMesh::Part& part, std::vector<float>& stream);

}  // namespace rhexis
