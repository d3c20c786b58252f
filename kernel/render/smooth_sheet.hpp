// SPDX-License-Identifier: GPL-3.0-or-later
// A sheet drawn finer than it is computed: each triangle as four, by Loop's rules, so that folds are round, and torn
// edges smooth curves.
#pragma once

#include <memory>
#include <vector>

#include "flow/membrane.hpp"

namespace rhexis {

/// Weights with which values at the nodes of a coarse mesh make those of a finer one.
struct Refinement {
    std::vector<int> offset;     ///< fine node count + 1
    std::vector<int> node;       ///< coarse nodes, offset[n] .. offset[n + 1] - 1 of each fine node
    std::vector<double> weight;  ///< as many
};

/// An edge of the fine mesh.
struct SheetEdge {
    int from = 0;
    int to = 0;
    int left = 0;    ///< third node of a triangle beside it
    int right = -1;  ///< of the other; -1: the sheet ends here
};

/// Of a mesh: each once, from its node of lower number, in order.
std::vector<SheetEdge> edges_of(const std::vector<std::array<int, 3>>& triangles);

class SmoothSheet {
public:
    explicit SmoothSheet(std::shared_ptr<const MembraneSheet> sheet);

    [[nodiscard]] const std::shared_ptr<const MembraneSheet>& sheet() const { return sheet_; }
    [[nodiscard]] const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
    /// All but the sheet's outer edge.
    [[nodiscard]] const std::vector<SheetEdge>& edges() const { return edges_; }
    [[nodiscard]] const std::vector<Vec3>& rest() const { return rest_; }  ///< [mm]

    /// Values at the fine nodes.
    [[nodiscard]] std::vector<Vec3> refined(const std::vector<Vec3>& at_coarse_nodes) const;

private:
    void find_edges();

    std::shared_ptr<const MembraneSheet> sheet_;
    std::vector<Refinement> levels_;
    std::vector<std::array<int, 3>> triangles_;
    std::vector<SheetEdge> edges_;
    std::vector<Vec3> rest_;
};

}  // namespace rhexis
