// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: which of many boxes are near a place, by a grid of cells over their middles.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "physics/contact/tool_shape.hpp"

namespace rhexis {

class BoxGrid {
public:
    /// One box or more.
    void fill(std::span<const Box> boxes);

    /// Calls take(box) once for each that comes within `reach` of a place, and for others near by, in no order that
    /// means anything.
    template <class Take>
    void near(const Vec3& place, double reach, const Take& take) const {
        const Vec3 around = half_ + Vec3::Constant(reach);
        const std::array<int, 3> first = cell_of(place - around);
        const std::array<int, 3> last = cell_of(place + around);
        for (int z = first[2]; z <= last[2]; ++z) {
            for (int y = first[1]; y <= last[1]; ++y) {
                const int end = offset_[cell(last[0], y, z) + 1];
                for (int i = offset_[cell(first[0], y, z)]; i < end; ++i) {
                    take(boxes_[static_cast<std::size_t>(i)]);
                }
            }
        }
    }

private:
    [[nodiscard]] std::array<int, 3> cell_of(const Vec3& point) const;
    [[nodiscard]] std::size_t cell(int x, int y, int z) const {
        return static_cast<std::size_t>((z * cells_[1] + y) * cells_[0] + x);
    }

    Vec3 low_ = Vec3::Zero();     ///< of the boxes' middles
    Vec3 half_ = Vec3::Zero();    ///< of the widest box, each way
    double size_ = 1.0;           ///< of a cell [mm]
    std::array<int, 3> cells_{};  ///< each way
    std::vector<int> offset_;     ///< per cell and one more: into boxes_
    std::vector<int> boxes_;      ///< each in the cell of its middle, so that a row of cells is one range
};

}  // namespace rhexis
