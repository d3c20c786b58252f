// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/elimination_tree.hpp"

#include <utility>

#include "base/index.hpp"

namespace rhexis {
namespace {

/// Calls visit(j, i) for every row j, ascending, and column i < j that it has an entry in.
template <typename Visit>
void visit_lower(const BlockPattern& pattern, const Visit& visit) {
    for (int j = 0; j < pattern.rows(); ++j) {
        for (int slot = pattern.first[at(j)]; slot < pattern.diagonal[at(j)]; ++slot) {
            visit(j, pattern.column[at(slot)]);
        }
    }
}

/// Calls enter(j, i) for every entry of the factor below its diagonal, rows j ascending: upwards in the tree from each
/// entry of the row.
template <typename Enter>
void visit_factor(const BlockPattern& pattern, const std::vector<int>& tree, const Enter& enter) {
    std::vector<int> met(at(pattern.rows()), -1);
    visit_lower(pattern, [&](int j, int i) {
        for (; i != j && met[at(i)] != j; i = tree[at(i)]) {
            met[at(i)] = j;
            enter(j, i);
        }
    });
}

}  // namespace

std::vector<int> elimination_tree(const BlockPattern& pattern) {
    std::vector<int> parent(at(pattern.rows()), -1);
    std::vector<int> ancestor(parent);  // short cuts upwards
    visit_lower(pattern, [&](int j, int i) {
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

FactorRows factor_rows(const BlockPattern& pattern, const std::vector<int>& tree) {
    FactorRows result;
    result.first.assign(tree.size() + 1, 0);
    std::vector<std::pair<int, int>> entries;  // of all rows, one after the other: column, row
    entries.reserve(4 * at(pattern.blocks()));
    visit_factor(pattern, tree, [&](int j, int i) {
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

}  // namespace rhexis
