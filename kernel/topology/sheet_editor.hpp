// SPDX-License-Identifier: GPL-3.0-or-later
// Inside topology: a sheet while it is being changed; what was done to it is kept as an edit.
#pragma once

#include <vector>

#include "flow/membrane_edit.hpp"

namespace rhexis {

class SheetEditor {
public:
    explicit SheetEditor(const MembraneSheet& sheet);

    [[nodiscard]] const TriMesh& mesh() const { return mesh_; }
    /// Triangles at a node, ascending.
    [[nodiscard]] std::vector<int> star(int node) const;
    /// The triangle that has this directed edge, or -1.
    [[nodiscard]] int triangle_with(int from, int to) const;
    [[nodiscard]] bool on_boundary(int node) const;

    /// Puts a node on an edge of two neighbouring nodes and splits the triangles there; returns it.
    int split_edge(int a, int b, double share);
    /// Opens the edge between two neighbouring nodes, `from` being on the boundary: the side to the right of the way
    /// gets copies of `from`, and of `to` where that is on the boundary too.
    void open_edge(int from, int to);
    /// Opens the two edges from a node inside the sheet.
    void open_slit(int from, int to, int middle);

    /// Thickness of the sheet along an edge: the mean of its triangles [mm].
    [[nodiscard]] double thickness_along(int a, int b) const;
    [[nodiscard]] int parent_of(int triangle) const { return parent_[static_cast<std::size_t>(triangle)]; }

    /// What was done.
    [[nodiscard]] MembraneEdit edit() const;

private:
    /// Triangles around `node` to the right of the way node -> first, until the boundary or the edge to `stop`.
    [[nodiscard]] std::vector<int> right_of(int node, int first, int stop) const;
    /// Triangles around `node` to the right of the way last -> node, until the boundary.
    [[nodiscard]] std::vector<int> right_before(int node, int last) const;
    int copy(int node);
    void replace(const std::vector<int>& triangles, int node, int by);

    const MembraneSheet* sheet_;
    TriMesh mesh_;
    std::vector<int> parent_;
    std::vector<SheetNode> nodes_;
};

}  // namespace rhexis
