// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files: legacy VTK and Gmsh, in text form, and OBJ surfaces.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "mesh/surface.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/tri_mesh.hpp"

namespace rhexis {

struct MeshFile {
    TetMesh mesh;                  ///< valid in the sense of validate_mesh
    std::vector<int> region_tags;  ///< region r had this tag in the file
};

/// Reads a tetrahedral mesh by the ending of its name. Lengths are taken as mm.
///   .vtk: legacy text, unstructured grid, versions 2 to 5; integer cell scalars "region", if any, 0 to 999.
///   .msh: Gmsh text, versions 2.2 and 4.1; physical volume tags, ascending, become regions 0, 1, ...
/// Lower-dimensional cells are left out, with nodes that only they use. Other solid cells, binary files, truncated
/// files and meshes that validate_mesh refuses are errors with path, line and element number (tetrahedra, from 0).
/// Memory stays within a small multiple of the file's size, whatever counts the file announces.
Result<MeshFile> read_tet_mesh(const std::string& path);

/// The same files as sheets: their triangles of 3 nodes, with the nodes that these use. validate_tri_mesh holds.
Result<TriMesh> read_tri_mesh(const std::string& path);

/// Writes a .vtk (legacy text 3.0, with cell scalars "region") or .msh (Gmsh 2.2 text, region r as physical volume
/// r + 1) file by the ending of the name. Coordinates survive the round trip exactly.
Status write_tet_mesh(const TetMesh& mesh, const std::string& path);

/// Writes triangles as a Wavefront .obj; positions: of all nodes that the surface indexes [mm].
Status write_obj(const Surface& surface, const std::vector<Vec3>& positions, const std::string& path);

}  // namespace rhexis
