// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/box_grid.hpp"

#include "base/index.hpp"

namespace rhexis {
namespace {

constexpr int most_cells = 64;  // each way

}  // namespace

std::array<int, 3> BoxGrid::cell_of(const Vec3& point) const {
    std::array<int, 3> cell{};
    for (int k = 0; k < 3; ++k) {
        const double along = std::clamp((point[k] - low_[k]) / size_, 0.0, static_cast<double>(cells_[at(k)] - 1));
        cell[at(k)] = static_cast<int>(along);
    }
    return cell;
}

void BoxGrid::fill(std::span<const Box> boxes) {
    Box all;
    double size = 0.0;
    for (const Box& box : boxes) {
        all.low = all.low.cwiseMin(box.low);
        all.high = all.high.cwiseMax(box.high);
        size += (box.high - box.low).maxCoeff();
    }
    low_ = all.low;
    size_ = std::max(size / static_cast<double>(boxes.size()), (all.high - all.low).maxCoeff() / most_cells);
    for (int k = 0; k < 3; ++k) {
        cells_[at(k)] = std::max(1, static_cast<int>((all.high[k] - all.low[k]) / size_) + 1);
    }
    offset_.assign(at(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
    const auto each_cell = [this](const Box& box, const auto& take) {
        const std::array<int, 3> first = cell_of(box.low);
        const std::array<int, 3> last = cell_of(box.high);
        for (int z = first[2]; z <= last[2]; ++z) {
            for (int y = first[1]; y <= last[1]; ++y) {
                for (int x = first[0]; x <= last[0]; ++x) {
                    take(cell(x, y, z));
                }
            }
        }
    };
    for (const Box& box : boxes) {
        each_cell(box, [this](std::size_t cell) { ++offset_[cell + 1]; });
    }
    for (std::size_t i = 1; i < offset_.size(); ++i) {
        offset_[i] += offset_[i - 1];
    }
    boxes_.resize(at(offset_.back()));
    std::vector<int> next(offset_.begin(), offset_.end() - 1);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        each_cell(boxes[b], [&](std::size_t cell) { boxes_[at(next[cell]++)] = static_cast<int>(b); });
    }
    asked_.assign(boxes.size(), 0);
    asking_ = 0;
}

}  // namespace rhexis
