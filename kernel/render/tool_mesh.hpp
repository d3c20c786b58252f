// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments as triangles. What the light meets is what is drawn: the same triangles cast their depth into the lens.
#pragma once

#include <vector>

#include "flow/tool.hpp"

namespace rhexis {

/// What a part of an instrument looks like.
enum class ToolFinish { titanium, bore, sleeve, steel, skin, lash, drape };

struct ToolMesh {
    struct Vertex {
        Vec3 place;   ///< in the tool's frame [mm]
        Vec3 normal;  ///< outward, unit
    };
    struct Part {
        ToolFinish finish = ToolFinish::steel;
        std::vector<Vertex> corners;  ///< three per triangle, counter-clockwise from outside
    };
    std::vector<Part> parts;  ///< opaque ones first
};

/// Triangles of an instrument. The last part goes on beyond its end, away from the tip, so that a shaft does not end in
/// mid-air; a phaco tip is a hollow needle cut at its bevel, opening to local +y, in a sleeve.
ToolMesh tool_mesh(const ToolModel& tool);

/// The parts as they are drawn: the last one continued.
std::vector<RoundedCone> drawn_parts(const ToolModel& tool);

/// Appends the corners as vertices: place and normal, 3 floats each.
void append_triangles(const ToolMesh::Part& part, std::vector<float>& stream);

}  // namespace rhexis
