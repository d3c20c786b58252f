// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: which triangles of a shell can meet which places of it, layers of what is folded or rolled.
#pragma once

#include <array>
#include <vector>

#include "flow/shell.hpp"
#include "physics/tool_shape.hpp"

namespace rhexis {

class ShellLayers {
public:
    /// The model must outlive this.
    explicit ShellLayers(const ShellModel& model);

    /// boxes: of the triangles now.
    void take(std::vector<Box> boxes);

    /// Triangles whose boxes come within `reach` of a point, ascending; but none that is near `nodes` along the
    /// surface: closer than one and a half times its thickness, by edges, or of the same nodes.
    void find(const Vec3& point, double reach, const std::array<int, 3>& nodes, std::vector<int>& triangles) const;

private:
    void find_near(const std::vector<std::vector<std::pair<int, double>>>& edges);
    [[nodiscard]] std::array<int, 3> cell_of(const Vec3& point) const;

    const ShellModel* model_;
    std::vector<std::vector<int>> near_;  ///< per triangle: nodes near it, ascending
    std::vector<Box> boxes_;
    Vec3 low_ = Vec3::Zero();
    double cell_ = 1.0;           ///< [mm]
    std::array<int, 3> cells_{};  ///< each way
    std::vector<int> offset_;     ///< per cell, into triangles_
    std::vector<int> triangles_;
};

}  // namespace rhexis
