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
    const auto middle = [](const Box& box) { return Vec3(0.5 * (box.low + box.high)); };
    Box all;
    double size = 0.0;
    half_ = Vec3::Zero();
    for (const Box& box : boxes) {
        all.add(middle(box), 0.0);
        half_ = half_.cwiseMax(0.5 * (box.high - box.low));
        size += (box.high - box.low).maxCoeff();
    }
    low_ = all.low;
    size_ = std::max(size / static_cast<double>(boxes.size()), (all.high - all.low).maxCoeff() / most_cells);
    for (int k = 0; k < 3; ++k) {
        cells_[at(k)] = std::max(1, static_cast<int>((all.high[k] - all.low[k]) / size_) + 1);
    }
    offset_.assign(at(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
    std::vector<std::size_t> in(boxes.size());
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        const std::array<int, 3> place = cell_of(middle(boxes[b]));
        in[b] = cell(place[0], place[1], place[2]);
        ++offset_[in[b] + 1];
    }
    for (std::size_t i = 1; i < offset_.size(); ++i) {
        offset_[i] += offset_[i - 1];
    }
    boxes_.resize(boxes.size());
    std::vector<int> next(offset_.begin(), offset_.end() - 1);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        boxes_[at(next[in[b]]++)] = static_cast<int>(b);
    }
}

}  // namespace rhexis
