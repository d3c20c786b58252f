// SPDX-License-Identifier: GPL-3.0-or-later
#include "track/replica.hpp"

#include "tools/instruments.hpp"

namespace rhexis::tracking {
namespace {

std::vector<Vec3> corners_of(const ToolMesh::Part& part) {
    std::vector<Vec3> corners;
    for (const ToolMesh::Vertex& corner : part.corners) {
        corners.push_back(corner.place);
    }
    return corners;
}

}  // namespace

Result<ToolMesh> instrument_mesh(const std::string& name) {
    const Result<ToolModel> tool = make_tool(name);
    if (tool) {
        return tool_mesh(tool.value());
    }
    const std::optional<ToolShape> shape = shape_of_instrument(name);
    return shape ? Result<ToolMesh>(tool_mesh(*shape)) : Result<ToolMesh>(tool.error());
}

Result<Replica> replica_of(const std::string& name) {
    const Result<ToolMesh> mesh = instrument_mesh(name);
    if (!mesh) {
        return mesh.error();
    }
    Replica replica;
    Result<Handle> handle = handle_of(mesh.value().bounds, name);
    if (!handle) {
        return handle.error();
    }
    replica.handle = std::move(handle).value();
    for (const ToolMesh::Part& part : mesh.value().parts) {
        if (part.finish == ToolFinish::bore) {
            continue;  // the inside of openings, which are closed
        }
        Result<Solid> shell = closed_shell(corners_of(part), name);
        if (!shell) {
            return shell.error();
        }
        replica.shape.push_back(std::move(shell).value());
    }
    return replica;
}

}  // namespace rhexis::tracking
