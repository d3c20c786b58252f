// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: which places of a membrane are nearest to a place of a shell, before it and behind it.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "flow/membrane.hpp"
#include "physics/contact/box_grid.hpp"

namespace rhexis {

class ShellSheet {
public:
    /// Where the membrane is. The state must outlive the calls that follow.
    void look(const MembraneState& sheet);

    struct Foot {
        double distance = HUGE_VAL;  ///< [mm]
        Vec3 way = Vec3::Zero();     ///< to it [mm]
        std::array<int, 3> nodes{};  ///< of the membrane
        std::array<double, 3> weights{};
    };
    /// Nearer to a place than `within` [mm], or infinitely far: [0] what lies behind a surface that looks along
    /// `forward` there, [1] before it.
    [[nodiscard]] std::array<Foot, 2> nearest(const Vec3& place, const Vec3& forward, double within);

private:
    const MembraneState* sheet_ = nullptr;
    std::vector<Box> boxes_;  ///< of triangles
    BoxGrid grid_;
};

}  // namespace rhexis
