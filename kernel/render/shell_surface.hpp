// SPDX-License-Identifier: GPL-3.0-or-later
// A thin shell as the closed surface of a body: its front and its back, half a thickness from the middle surface, and
// the rim between them. Each triangle is drawn as four: the middle of a side lies on the cubic that leaves both corners
// along the side as they have turned it, so that what is bent looks round.
#pragma once

#include <array>
#include <vector>

#include "flow/shell.hpp"
#include "render/smooth_sheet.hpp"

namespace rhexis {

class ShellSurface {
public:
    explicit ShellSurface(const ShellModel& model);

    [[nodiscard]] const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }  ///< outside in front
    [[nodiscard]] const std::vector<SheetEdge>& edges() const { return edges_; }
    [[nodiscard]] const std::vector<Vec3>& rest() const { return rest_; }  ///< [mm]

    /// Of all nodes of the surface.
    [[nodiscard]] std::vector<Vec3> places(const ShellState& state) const;

private:
    struct Side {
        int from = 0;
        int to = 0;
        bool open = false;  ///< the shell ends here
    };
    std::vector<int> split(const TriMesh& mesh);
    void close(const TriMesh& mesh, const std::vector<int>& side_of);
    void find_normals(const TriMesh& mesh);
    void find_thickness(const ShellModel& model);

    std::vector<Side> sides_;
    std::vector<Vec3> node_;         ///< of the shell at rest
    std::vector<Vec3> normal_;       ///< likewise
    std::vector<double> thickness_;  ///< likewise
    std::vector<std::array<int, 3>> triangles_;
    std::vector<SheetEdge> edges_;
    std::vector<Vec3> rest_;
};

}  // namespace rhexis
