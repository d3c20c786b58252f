// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to keep the bulk of linear tetrahedra from locking, of which the kernel has one (Formulation::edge_smoothed):
// what changes shape is averaged over edges, what changes volume over something larger.
#pragma once

#include <vector>

#include "energy/gradient_elements.hpp"

namespace rhexis::bench {

/// Over what lambda beyond `kept` times mu is averaged. Up to that it stays at the edges.
enum class BulkOver {
    edges,         ///< all of lambda: nothing but edges
    nodes,         ///< patches around every node, which overlap
    patches,       ///< tet_patches of `tetrahedra`
    node_patches,  ///< all around a node, for nodes that share no tetrahedron; what is left between joins a neighbour
};

struct AveragedBulk {
    BulkOver over = BulkOver::edges;
    int tetrahedra = 0;        ///< of a patch
    double kept = -2.0 / 3.0;  ///< that: edges change shape only
};

/// Elements whose energies add up to that of the mesh.
std::vector<GradientElements> averaged_bulk(const TetMesh& mesh, const std::vector<TetStiffness>& stiffness,
                                            const AveragedBulk& way);

}  // namespace rhexis::bench
