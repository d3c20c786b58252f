// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/packed_factor.hpp"

#include <algorithm>
#include <utility>

#include "base/assert.hpp"
#include "base/index.hpp"

namespace rhexis {
namespace {

using linear_kernel::Front;
using linear_kernel::front_unit;
using linear_kernel::Panel;
using linear_kernel::row_unit;

constexpr std::size_t register_room = 32;  ///< numbers behind what is used, that a register may reach

/// Room for so many numbers; with some to spare, so that a matrix that grows slowly seldom asks for more.
void make_room(AlignedVector<float>& numbers, std::size_t count) {
    if (numbers.size() < count + register_room) {
        numbers.resize(count + count / 8 + register_room);
    }
}

int round_up(int n, int unit) { return (n + unit - 1) / unit * unit; }

constexpr int cut_nodes = 16;  ///< panels wider than this are cut, so that inverting their triangles stays cheap

/// Numbers that a triangle of so many columns takes, up to the next line of the cache.
std::size_t triangle_size(int columns) { return at(round_up(round_up(columns, row_unit) * columns, front_unit)); }

void copy_rows(const float* from, int rows, float*& to) { to = std::copy(from, from + rows, to); }

/// Whether every panel comes right behind all that leads to it.
bool postordered_tree(const Supernodes& tree) {
    std::vector<int> size(at(tree.count()), 1);  // of what leads to each panel, and itself
    std::vector<int> first(at(tree.count()));
    for (int s = 0; s < tree.count(); ++s) {
        first[at(s)] = s;
    }
    for (int s = 0; s < tree.count(); ++s) {
        if (s - first[at(s)] + 1 != size[at(s)]) {
            return false;
        }
        const int parent = tree.parent[at(s)];
        if (parent >= 0) {
            size[at(parent)] += size[at(s)];
            first[at(parent)] = std::min(first[at(parent)], first[at(s)]);
        }
    }
    return true;
}

}  // namespace

PackedFactor::PackedFactor(const BlockPattern& pattern, const linear_kernel::Kernel& kernel)
    : pattern_(&pattern), kernel_(&kernel) {
    follow(pattern);
}

void PackedFactor::follow(const BlockPattern& pattern, std::span<const int> row_now) {
    factored_ = false;
    pattern_ = &pattern;
    if (row_now.empty() || !grow(tree_, pattern, row_now)) {
        tree_ = find_supernodes(pattern);
    }
    lay_out();
    find_children();
    find_places();
}

/// The panels that the solve works with for panel s of the tree; returns the numbers stored so far.
std::size_t PackedFactor::lay_out_panels(int s, std::size_t size) {
    first_panel_.push_back(static_cast<int>(panels_.size()));
    const int end = tree_.first[at(s) + 1];
    for (int first = tree_.first[at(s)]; first < end; first += cut_nodes) {
        const int own = std::min(cut_nodes, end - first);
        const int below = end - first - own + tree_.below(s);
        Panel panel{first, 3 * own, below, static_cast<int>(nodes_.size()), round_up(3 * below, front_unit), size, 0};
        panel.below = size + triangle_size(3 * own);
        size = panel.below + at(panel.leading) * at(panel.width);
        panels_.push_back(panel);
        solve_work_ += 2.0 * panel.width * (round_up(panel.width, row_unit) + round_up(3 * below, row_unit));
        for (int node = first + own; node < end; ++node) {
            nodes_.push_back(node);
        }
        nodes_.insert(nodes_.end(), tree_.row.begin() + tree_.row_first[at(s)],
                      tree_.row.begin() + tree_.row_first[at(s) + 1]);
    }
    return size;
}

void PackedFactor::lay_out() {
    panels_.clear();
    first_panel_.clear();
    nodes_.clear();
    factor_work_ = solve_work_ = 0.0;
    std::size_t size = 0;
    int longest = 0;
    std::size_t pivots = 0;
    std::size_t cut = 0;
    for (int s = 0; s < tree_.count(); ++s) {
        size = lay_out_panels(s, size);
        const int width = 3 * tree_.width(s);
        const int below = 3 * tree_.below(s);
        longest = std::max(longest, width + below);
        pivots = std::max(pivots, at(round_up(width, front_unit)) * at(width));
        if (tree_.width(s) > cut_nodes) {
            cut = std::max(cut, at(round_up(below, front_unit)) * at(width));
        }
        for (double w = width; w > 0.0; w -= 1.0) {
            factor_work_ += 0.5 * (w + below) * (w + below);
        }
    }
    first_panel_.push_back(static_cast<int>(panels_.size()));
    make_room(values_, size);
    make_room(pivots_, pivots);
    make_room(below_, cut);
    make_room(work_, 9 * 3 * at(cut_nodes) + at(longest) + 8 * at(row_unit));
    make_room(inverse_, 9 * at(cut_nodes) * at(cut_nodes));
}

/// Who hands on to whom, and how much room what is handed on takes: children end before their parent starts, so that
/// each level's stack grows and shrinks at its end. Where other panels come between, it only grows.
void PackedFactor::find_children() {
    const int count = tree_.count();
    first_child_.assign(at(count) + 1, 0);
    for (const int parent : tree_.parent) {
        first_child_[at(parent >= 0 ? parent : count)] += parent >= 0 ? 1 : 0;
    }
    int sum = 0;
    for (int& first : first_child_) {
        sum += std::exchange(first, sum);
    }
    children_.resize(at(sum));
    std::vector<int> next(first_child_);
    level_.assign(at(count), 0);
    for (int s = 0; s < count; ++s) {
        if (tree_.parent[at(s)] >= 0) {
            children_[at(next[at(tree_.parent[at(s)])]++)] = {s, 0, 0};
        }
    }
    for (int s = count - 1; s >= 0; --s) {
        level_[at(s)] = tree_.parent[at(s)] >= 0 ? 1 - level_[at(tree_.parent[at(s)])] : 0;
    }
    const bool shrinks = postordered_tree(tree_);
    std::array<std::size_t, 2> top{};
    std::array<std::size_t, 2> most{};
    rest_of_.resize(at(count));
    for (int s = 0; s < count; ++s) {
        const std::size_t own = level_[at(s)];
        rest_of_[at(s)] = top[own];
        top[own] += at(round_up(3 * tree_.below(s), front_unit)) * at(3 * tree_.below(s));
        most[own] = std::max(most[own], top[own]);
        if (shrinks && first_child_[at(s)] < first_child_[at(s) + 1]) {
            top[1 - own] = rest_of_[at(children_[at(first_child_[at(s)])].panel)];
        }
    }
    make_room(rest_[0], most[0]);
    make_room(rest_[1], most[1]);
}

/// Rows of the child that follow one another in the parent's front too.
void PackedFactor::find_runs(const std::vector<int>& local, Child& child, int pivots) {
    child.first_run = static_cast<int>(runs_.size());
    const int* const row = tree_.row.data() + tree_.row_first[at(child.panel)];
    for (int k = 0; k < tree_.below(child.panel); ++k) {
        const int place = local[at(row[k])];
        const bool goes_on = k > 0 && place == local[at(row[k - 1])] + 1 && place != pivots;
        if (goes_on) {
            ++runs_.back().nodes;
        } else {
            runs_.push_back({k, place, 1});
        }
    }
    child.end_run = static_cast<int>(runs_.size());
}

void PackedFactor::find_places() {
    std::vector<int> local(at(pattern_->rows()), -1);
    place_.resize(at(pattern_->blocks()));
    runs_.clear();
    for (int s = 0; s < tree_.count(); ++s) {
        const int width = tree_.width(s);
        for (int k = 0; k < width; ++k) {
            local[at(tree_.first[at(s)] + k)] = k;
        }
        const int* const row = tree_.row.data() + tree_.row_first[at(s)];
        for (int k = 0; k < tree_.below(s); ++k) {
            local[at(row[k])] = width + k;
        }
        for (int j = tree_.first[at(s)]; j < tree_.first[at(s) + 1]; ++j) {
            for (int slot = pattern_->diagonal[at(j)]; slot < pattern_->first[at(j) + 1]; ++slot) {
                place_[at(slot)] = local[at(pattern_->column[at(slot)])];
            }
        }
        for (int c = first_child_[at(s)]; c < first_child_[at(s) + 1]; ++c) {
            find_runs(local, children_[at(c)], width);
        }
    }
}

Front PackedFactor::front_of(int s) {
    Front front;
    front.pivots = 3 * tree_.width(s);
    front.pivot_leading = round_up(front.pivots, front_unit);
    front.below_rows = 3 * tree_.below(s);
    front.below_leading = round_up(front.below_rows, front_unit);
    front.pivot = pivots_.data();
    front.below = tree_.width(s) > cut_nodes ? below_.data() : values_.data() + panels_[at(first_panel_[at(s)])].below;
    front.rest = rest_[level_[at(s)]].data() + rest_of_[at(s)];
    front.fresh = first_child_[at(s)] == first_child_[at(s) + 1];
    return front;
}

void PackedFactor::extend(int s, const Front& front) {
    for (int c = first_child_[at(s) + 1]; c-- > first_child_[at(s)];) {
        const Child& child = children_[at(c)];
        kernel_->extend(rest_[level_[at(child.panel)]].data() + rest_of_[at(child.panel)],
                        round_up(3 * tree_.below(child.panel), front_unit), runs_.data() + child.first_run,
                        child.end_run - child.first_run, front);
    }
}

/// Inverts the triangles, and of a panel that is cut copies the rows below each part.
void PackedFactor::keep_panels(int s, const Front& front) {
    for (int p = first_panel_[at(s)]; p < first_panel_[at(s) + 1]; ++p) {
        const Panel& panel = panels_[at(p)];
        const int first = 3 * (panel.first_node - tree_.first[at(s)]);
        const float* const corner = front.pivot + at(front.pivot_leading) * at(first);
        kernel_->invert(corner + first, front.pivot_leading, panel.width, inverse_.data(),
                        values_.data() + panel.triangle);
        if (tree_.width(s) <= cut_nodes) {
            return;
        }
        const int pivot_rows = front.pivots - first - panel.width;
        float* to = values_.data() + panel.below;
        for (int j = 0; j < panel.width; ++j) {
            copy_rows(corner + at(front.pivot_leading) * at(j) + first + panel.width, pivot_rows, to);
            copy_rows(front.below + at(front.below_leading) * at(first + j), front.below_rows, to);
            to = std::fill_n(to, panel.leading - pivot_rows - front.below_rows, 0.0F);
        }
    }
}

bool PackedFactor::factor(const BlockValues& values) {
    factored_ = false;
    const linear_kernel::Blocks matrix{pattern_->rows(), pattern_->first.data(), pattern_->column.data(),
                                       values.data()};
    for (int s = 0; s < tree_.count(); ++s) {
        const Front front = front_of(s);
        kernel_->gather(matrix, pattern_->diagonal.data(), place_.data(), tree_.first[at(s)], front);
        extend(s, front);
        if (!kernel_->eliminate(front)) {
            return false;
        }
        keep_panels(s, front);
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
