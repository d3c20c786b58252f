// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: where the nodes that a tear adds to a sheet are eliminated.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "math/block_matrix.hpp"
#include "mesh/tri_mesh.hpp"

namespace rhexis {

struct RowsWithAdded {
    std::vector<int> node_of;  ///< per row
    std::vector<int> row_of;   ///< per node
    std::vector<int> row_now;  ///< per row before
};

/// The order before with each added node right behind an old one that had all its neighbours for its own: eliminated
/// with that one, it adds the fewest entries to the factor. node_of, row_of, pattern: of the sheet before; changed:
/// triangles that are not as they were, all those of added nodes. None where a node has no such place.
std::optional<RowsWithAdded> with_added_nodes(const std::vector<int>& node_of, const std::vector<int>& row_of,
                                              const BlockPattern& pattern, const TriMesh& mesh,
                                              std::span<const int> changed);

}  // namespace rhexis
