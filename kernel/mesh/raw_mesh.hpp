// SPDX-License-Identifier: GPL-3.0-or-later
// Inside mesh: what the readers of mesh files collect, before it is checked.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "mesh/io.hpp"
#include "mesh/token_reader.hpp"
#include "mesh/validate.hpp"

namespace rhexis {

struct RawMesh {
    std::vector<Vec3> nodes;
    std::vector<int> node_line;
    std::vector<std::int64_t> node_number;    ///< as the file counts
    std::vector<std::uint8_t> in_lower_cell;  ///< per node: 1 if a point, line or surface cell uses it
    std::vector<std::array<int, 4>> tets;
    std::vector<int> tet_line;
    std::vector<std::int64_t> tet_number;
    std::vector<int> tag;  ///< one per tetrahedron, or empty
    std::vector<std::array<int, 3>> triangles;
};

/// Kinds of cells by dimension and number of nodes.
struct CellKind {
    int code;
    int dimension;
    int nodes;
};

/// A cell of the file: its line and its number there.
struct CellPlace {
    int line;
    std::int64_t number;
};

/// Adds one cell to a raw mesh, or fails in the reader: only tetrahedra of 4 nodes are solids we take. kind: null if
/// the file's code is unknown. nodes: indices from 0. True if the cell was a tetrahedron.
bool add_cell(const CellKind* kind, std::int64_t code, std::span<const int> nodes, CellPlace place, RawMesh& raw,
              TokenReader& reader);

/// Drops nodes that no tetrahedron uses, makes regions of tags and validates. rank_tags: regions are the ranks of the
/// tags that occur; otherwise they are the tags, where these are 0 to 999.
Result<MeshFile> finish_mesh(RawMesh raw, bool rank_tags, const std::string& path);

/// The triangles of the file and the nodes that they use.
Result<TriMesh> finish_sheet(RawMesh raw, const std::string& path);

Result<RawMesh> read_vtk(std::string_view text, const std::string& path);
Result<RawMesh> read_msh(std::string_view text, const std::string& path);

}  // namespace rhexis
