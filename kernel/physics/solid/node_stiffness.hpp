// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: how stiffly each node is held by what is around it. A node that little mass belongs to, beside a cut
// or among remains, would swing faster than the rest of the body and shorten everyone's explicit step.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "flow/solid.hpp"

namespace rhexis {

/// Keeps the mesh's pattern; the shares of its tetrahedra change.
class NodeStiffness {
public:
    NodeStiffness(const TetMesh& mesh, Formulation formulation);

    /// Per node the trace of its own block of the stiffness matrix at rest [uN/mm]. One share per tetrahedron.
    const std::vector<double>& traces(const std::vector<TetStiffness>& shares);

private:
    void add_rows(int patch, std::span<const int> star);

    const TetMesh* mesh_;
    Formulation formulation_;
    std::vector<std::array<Vec3, 4>> gradients_;  ///< of the four shape functions [1/mm]
    std::vector<double> volumes_;                 ///< at rest [mm^3]
    std::vector<std::array<int, 16>> pair_;       ///< per tetrahedron and corners (patch, node): a row of dilation_
    std::vector<int> patch_;                      ///< per row
    std::vector<int> node_;                       ///< per row
    std::vector<Vec3> dilation_;                  ///< per row: d(volume of the patch) / d(node) [mm^2]
    std::vector<double> traces_;
};

}  // namespace rhexis
