// SPDX-License-Identifier: GPL-3.0-or-later
// Is a tetrahedral mesh fit for mechanics?
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "mesh/tet_mesh.hpp"

namespace rhexis {

/// Where the parts of a mesh stand in a file, for error messages. Lines count from 1.
struct MeshSource {
    std::string path;
    std::vector<int> node_line;
    std::vector<int> tet_line;
    std::vector<std::int64_t> node_number;  ///< as the file counts them; empty: from 0
    std::vector<std::int64_t> tet_number;
};

/// Every node finite and used; every tetrahedron with four different nodes that exist, positive volume, not flat, not
/// listed twice, region >= 0; no face shared by more than two tetrahedra. Otherwise the first fault, with the number of
/// the node or element (from 0; the file's where a source gives it) and its line where a source is given.
Status validate_mesh(const TetMesh& mesh, const MeshSource* source = nullptr);

}  // namespace rhexis
