// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files: legacy VTK and Gmsh, as text or bytes, and OBJ surfaces.
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
    int nodes_of_no_cell = 0;      ///< of the file, that are left out
};

/// Reads a tetrahedral mesh by the ending of its name. Lengths are taken as mm.
///   .vtk: legacy form, ASCII or BINARY, unstructured grid, versions 2 to 5. Cell scalars "region" of whole numbers, if
///         any, are the regions where they are 0 to 999; other numbers, ascending, become regions 0, 1, ... Other
///         attributes are skipped.
///   .msh: Gmsh, versions 1 ($NOD), 2, 4.0 and 4.1, text or binary; physical volume tags, ascending, become regions
///         0, 1, ...
/// Lower-dimensional cells are left out, and so are nodes that no tetrahedron uses. Other solid cells, truncated files
/// and meshes that validate_mesh refuses are errors with path, line (or byte) and the file's number of node or element.
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
