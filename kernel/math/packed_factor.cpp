// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/packed_factor.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "base/index.hpp"

namespace rhexis {
namespace {

using linear_kernel::row_block;
using linear_kernel::row_unit;

int round_up(int n, int unit) { return (n + unit - 1) / unit * unit; }

constexpr int cut_nodes = 16;  ///< panels wider than this are cut, so that inverting their triangles stays cheap

/// Numbers that blocks of up to 64 rows take.
std::size_t stored(int rows, int columns) { return at(round_up(rows, row_unit)) * at(columns); }

/// Copies a matrix into blocks; from[i * row_step + j * column_step] is its entry (i, j).
void pack(const float* from, std::size_t row_step, std::size_t column_step, int rows, int columns, float* to) {
    for (int i = 0; i < rows; i += row_block) {
        const int height = std::min(row_block, round_up(rows - i, row_unit));
        const int filled = std::min(height, rows - i);
        for (int j = 0; j < columns; ++j, to += height) {
            const float* const column = from + at(i) * row_step + at(j) * column_step;
            for (int r = 0; r < filled; ++r) {
                to[r] = column[at(r) * row_step];
            }
            std::fill(to + filled, to + height, 0.0F);
        }
    }
}

}  // namespace

PackedFactor::PackedFactor(const BlockPattern& pattern, const linear_kernel::Kernel& kernel)
    : pattern_(&pattern), kernel_(&kernel), tree_(find_supernodes(pattern)) {
    lay_out();
    find_places();
}

/// The panels that the solve works with for panel s of the tree; returns the numbers stored so far.
std::size_t PackedFactor::lay_out_panels(int s, std::size_t size) {
    first_panel_.push_back(static_cast<int>(panels_.size()));
    const int end = tree_.first[at(s) + 1];
    for (int first = tree_.first[at(s)]; first < end; first += cut_nodes) {
        const int own = std::min(cut_nodes, end - first);
        const int below = end - first - own + tree_.below(s);
        linear_kernel::Panel panel{first, 3 * own, below, static_cast<int>(nodes_.size()), size, 0};
        panel.below = size + stored(3 * own, 3 * own);
        size = panel.below + stored(3 * below, 3 * own);
        panels_.push_back(panel);
        for (int node = first + own; node < end; ++node) {
            nodes_.push_back(node);
        }
        nodes_.insert(nodes_.end(), tree_.row.begin() + tree_.row_first[at(s)],
                      tree_.row.begin() + tree_.row_first[at(s) + 1]);
    }
    return size;
}

void PackedFactor::lay_out() {
    std::size_t size = 0;
    int longest = 0;
    for (int s = 0; s < tree_.count(); ++s) {
        size = lay_out_panels(s, size);
        const int all = 3 * front_nodes(s);
        longest = std::max(longest, all);
        for (double w = 3 * tree_.width(s); w > 0.0; w -= 1.0) {
            const double height = w + 3 * tree_.below(s);
            factor_work_ += 0.5 * height * height;
        }
    }
    first_panel_.push_back(static_cast<int>(panels_.size()));
    solve_work_ = 2.0 * static_cast<double>(size);
    values_.resize(size + at(row_unit));
    const std::size_t side = at(round_up(longest, linear_kernel::front_unit));
    front_.resize(side * side);
    work_.resize(9 * 3 * at(cut_nodes) + at(longest) + 8 * at(row_unit));
    triangle_.resize(9 * at(cut_nodes) * at(cut_nodes));
    rest_of_.resize(at(tree_.count()));
}

void PackedFactor::find_places() {
    std::vector<int> local(at(pattern_->rows()), -1);
    children_.resize(at(tree_.count()));
    place_.assign(at(pattern_->blocks()), -1);
    std::vector<std::vector<int>> below(at(tree_.count()));
    for (int s = 0; s < tree_.count(); ++s) {
        if (tree_.parent[at(s)] >= 0) {
            children_[at(tree_.parent[at(s)])].push_back({s, {}});
        }
    }
    for (int s = 0; s < tree_.count(); ++s) {
        for (int k = 0; k < tree_.width(s); ++k) {
            local[at(tree_.first[at(s)] + k)] = k;
        }
        for (int k = 0; k < tree_.below(s); ++k) {
            local[at(tree_.row[at(tree_.row_first[at(s)] + k)])] = tree_.width(s) + k;
        }
        for (int j = tree_.first[at(s)]; j < tree_.first[at(s) + 1]; ++j) {
            for (int slot = pattern_->diagonal[at(j)]; slot < pattern_->first[at(j) + 1]; ++slot) {
                place_[at(slot)] = local[at(pattern_->column[at(slot)])];
            }
        }
        for (Child& child : children_[at(s)]) {
            for (int k = 0; k < tree_.below(child.panel); ++k) {
                child.place.push_back(local[at(tree_.row[at(tree_.row_first[at(child.panel)] + k)])]);
            }
        }
    }
}

/// Starts the front of panel s with its entries of A.
void PackedFactor::gather(int s, const BlockValues& values) {
    const int size = 3 * front_nodes(s);
    leading_ = round_up(size, linear_kernel::front_unit);
    std::fill_n(front_.begin(), at(leading_) * at(size), 0.0F);
    for (int j = tree_.first[at(s)]; j < tree_.first[at(s) + 1]; ++j) {
        const int column = 3 * (j - tree_.first[at(s)]);
        for (int slot = pattern_->diagonal[at(j)]; slot < pattern_->first[at(j) + 1]; ++slot) {
            const double* const block = values.data() + 9 * at(slot);  // (j, i): the transpose of what is wanted
            float* const target = front_.data() + at(leading_) * at(column) + 3 * at(place_[at(slot)]);
            for (std::size_t c = 0; c < 3; ++c) {
                for (std::size_t r = 0; r < 3; ++r) {
                    target[at(leading_) * c + r] = static_cast<float>(block[3 * r + c]);
                }
            }
        }
    }
}

void PackedFactor::keep_panel(int s) {
    for (int p = first_panel_[at(s)]; p < first_panel_[at(s) + 1]; ++p) {
        const linear_kernel::Panel& panel = panels_[at(p)];
        const std::size_t column = 3 * at(panel.first_node - tree_.first[at(s)]);
        const float* const corner = front_.data() + column * (at(leading_) + 1);
        const int length = round_up(panel.width, linear_kernel::front_unit);
        kernel_->invert(corner, leading_, panel.width, triangle_.data());
        pack(triangle_.data(), at(length), 1, panel.width, panel.width, values_.data() + panel.triangle);
        pack(corner + panel.width, 1, at(leading_), 3 * panel.below_nodes, panel.width, values_.data() + panel.below);
    }
}

/// Moves what is left of the front onto the stack.
void PackedFactor::keep_rest(int s) {
    const std::size_t width = 3 * at(tree_.width(s));
    const std::size_t height = 3 * at(tree_.below(s));
    rest_of_[at(s)] = rest_top_;
    rest_top_ += height * height;
    if (rest_.size() < rest_top_) {
        rest_.resize(rest_top_);
    }
    for (std::size_t j = 0; j < height; ++j) {
        const float* const column = front_.data() + at(leading_) * (width + j) + width;
        std::copy(column + j, column + height, rest_.data() + rest_of_[at(s)] + height * j + j);
    }
}

bool PackedFactor::factor(const BlockValues& values) {
    factored_ = false;
    rest_top_ = 0;
    for (int s = 0; s < tree_.count(); ++s) {
        gather(s, values);
        const std::vector<Child>& children = children_[at(s)];
        for (std::size_t c = children.size(); c > 0; --c) {
            const Child& child = children[c - 1];
            kernel_->extend(rest_.data() + rest_of_[at(child.panel)], child.place.data(),
                            static_cast<int>(child.place.size()), front_.data(), leading_);
        }
        if (!children.empty()) {
            rest_top_ = rest_of_[at(children.front().panel)];
        }
        if (!kernel_->eliminate(front_.data(), leading_, 3 * tree_.width(s), 3 * front_nodes(s))) {
            return false;
        }
        keep_panel(s);
        keep_rest(s);
    }
    factored_ = true;
    return true;
}

void PackedFactor::solve(std::span<float> x) {
    RHEXIS_ASSERT(factored_ && x.size() >= 4 * at(pattern_->rows()));
    kernel_->solve(panels_.data(), static_cast<int>(panels_.size()), values_.data(), nodes_.data(), x.data(),
                   work_.data());
}

}  // namespace rhexis
