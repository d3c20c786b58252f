// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: which of many boxes are near a place, by a grid of cells.
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

    /// Calls take(box) for each whose cells come within `reach` of a place, once, in no order that means anything.
    template <class Take>
    void near(const Vec3& place, double reach, const Take& take) {
        ++asking_;
        const std::array<int, 3> first = cell_of(place - Vec3::Constant(reach));
        const std::array<int, 3> last = cell_of(place + Vec3::Constant(reach));
        for (int z = first[2]; z <= last[2]; ++z) {
            for (int y = first[1]; y <= last[1]; ++y) {
                for (int x = first[0]; x <= last[0]; ++x) {
                    for (const int box : in_cell(cell(x, y, z))) {
                        int& asked = asked_[static_cast<std::size_t>(box)];
                        if (asked != asking_) {
                            asked = asking_;
                            take(box);
                        }
                    }
                }
            }
        }
    }

private:
    [[nodiscard]] std::array<int, 3> cell_of(const Vec3& point) const;
    [[nodiscard]] std::size_t cell(int x, int y, int z) const {
        return static_cast<std::size_t>((z * cells_[1] + y) * cells_[0] + x);
    }
    [[nodiscard]] std::span<const int> in_cell(std::size_t cell) const {
        return {boxes_.data() + offset_[cell], boxes_.data() + offset_[cell + 1]};
    }

    Vec3 low_ = Vec3::Zero();
    double size_ = 1.0;           ///< of a cell [mm]
    std::array<int, 3> cells_{};  ///< each way
    std::vector<int> offset_;     ///< per cell and one more: into boxes_
    std::vector<int> boxes_;
    std::vector<int> asked_;  ///< per box: the last call that met it
    int asking_ = 0;
};

}  // namespace rhexis
