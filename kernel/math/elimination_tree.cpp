// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/elimination_tree.hpp"

#include <utility>

#include "base/assert.hpp"
#include "base/index.hpp"

namespace rhexis {
namespace {

/// Calls visit(j, i) for every row j, ascending, and column i < j that it has an entry in. place: of each row of the
/// pattern, and its inverse; or null for the order of the pattern.
template <typename Visit>
void visit_lower(const BlockPattern& pattern, const int* order, const int* place, const Visit& visit) {
    for (int j = 0; j < pattern.rows(); ++j) {
        const int row = order != nullptr ? order[j] : j;
        const int end = order != nullptr ? pattern.first[at(row) + 1] : pattern.diagonal[at(row)];
        for (int slot = pattern.first[at(row)]; slot < end; ++slot) {
            const int i = place != nullptr ? place[pattern.column[at(slot)]] : pattern.column[at(slot)];
            if (i < j) {
                visit(j, i);
            }
        }
    }
}

std::vector<int> tree_of(const BlockPattern& pattern, const int* order, const int* place) {
    std::vector<int> parent(at(pattern.rows()), -1);
    std::vector<int> ancestor(parent);  // short cuts upwards
    visit_lower(pattern, order, place, [&](int j, int i) {
        while (i != -1 && i != j) {
            const int next = ancestor[at(i)];
            ancestor[at(i)] = j;
            if (next == -1) {
                parent[at(i)] = j;
            }
            i = next;
        }
    });
    return parent;
}

/// Calls enter(j, i) for every entry of the factor below its diagonal, rows j ascending: upwards in the tree from each
/// entry of the row.
template <typename Enter>
void visit_factor(const BlockPattern& pattern, const int* order, const int* place, const std::vector<int>& tree,
                  const Enter& enter) {
    std::vector<int> met(at(pattern.rows()), -1);
    visit_lower(pattern, order, place, [&](int j, int i) {
        for (; i != j && met[at(i)] != j; i = tree[at(i)]) {
            met[at(i)] = j;
            enter(j, i);
        }
    });
}

/// Children by weight, then by number, one list after the other.
struct Children {
    std::vector<int> first;  ///< of each column's list, or -1
    std::vector<int> next;
};

Children children_by(const std::vector<int>& tree, const std::vector<int>& weight) {
    const int n = static_cast<int>(tree.size());
    std::vector<int> of_weight(at(n), -1);
    std::vector<int> next(at(n), -1);
    for (int j = 0; j < n; ++j) {
        next[at(j)] = std::exchange(of_weight[at(weight[at(j)])], j);
    }
    Children children{std::vector<int>(at(n), -1), std::vector<int>(at(n), -1)};
    for (int w = n - 1; w >= 0; --w) {
        for (int j = of_weight[at(w)]; j >= 0; j = next[at(j)]) {
            if (tree[at(j)] >= 0) {
                children.next[at(j)] = std::exchange(children.first[at(tree[at(j)])], j);
            }
        }
    }
    return children;
}

/// Children before their parents.
std::vector<int> depth_first(const std::vector<int>& tree, Children children) {
    std::vector<int> result;
    result.reserve(tree.size());
    std::vector<int> path;
    for (int root = 0; root < static_cast<int>(tree.size()); ++root) {
        if (tree[at(root)] >= 0) {
            continue;
        }
        path.push_back(root);
        while (!path.empty()) {
            const int j = path.back();
            const int child = children.first[at(j)];
            if (child >= 0) {
                children.first[at(j)] = children.next[at(child)];
                path.push_back(child);
            } else {
                result.push_back(j);
                path.pop_back();
            }
        }
    }
    return result;
}

}  // namespace

std::vector<int> elimination_tree(const BlockPattern& pattern) { return tree_of(pattern, nullptr, nullptr); }

FactorRows factor_rows(const BlockPattern& pattern, const std::vector<int>& tree) {
    FactorRows result;
    result.first.assign(tree.size() + 1, 0);
    std::vector<std::pair<int, int>> entries;  // of all rows, one after the other: column, row
    entries.reserve(4 * at(pattern.blocks()));
    visit_factor(pattern, nullptr, nullptr, tree, [&](int j, int i) {
        ++result.first[at(i) + 1];
        entries.emplace_back(i, j);
    });
    for (std::size_t j = 0; j < tree.size(); ++j) {
        result.first[j + 1] += result.first[j];
    }
    result.row.resize(entries.size());
    std::vector<int> next(result.first.begin(), result.first.end() - 1);
    for (const auto& [column, row] : entries) {
        result.row[at(next[at(column)]++)] = row;
    }
    return result;
}

std::vector<int> postordered(const BlockPattern& pattern, std::vector<int> order) {
    RHEXIS_ASSERT(static_cast<int>(order.size()) == pattern.rows());
    std::vector<int> place(order.size());
    for (std::size_t j = 0; j < order.size(); ++j) {
        place[at(order[j])] = static_cast<int>(j);
    }
    const std::vector<int> tree = tree_of(pattern, order.data(), place.data());
    std::vector<int> rows(order.size(), 0);
    visit_factor(pattern, order.data(), place.data(), tree, [&](int, int i) { ++rows[at(i)]; });
    std::vector<int> result = depth_first(tree, children_by(tree, rows));
    for (int& j : result) {
        j = order[at(j)];
    }
    return result;
}

}  // namespace rhexis
