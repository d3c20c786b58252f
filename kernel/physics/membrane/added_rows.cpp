// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane/added_rows.hpp"

#include <algorithm>
#include <utility>

#include "base/index.hpp"

namespace rhexis {
namespace {

/// The first row that has an entry with each of some, and is none of them or has one with itself; or -1.
int common_row(const BlockPattern& pattern, const std::vector<int>& rows) {
    if (rows.empty()) {
        return -1;
    }
    for (int slot = pattern.first[at(rows[0])]; slot < pattern.first[at(rows[0]) + 1]; ++slot) {
        const int row = pattern.column[at(slot)];
        if (std::all_of(rows.begin() + 1, rows.end(), [&](int other) { return pattern.slot(other, row) >= 0; })) {
            return row;
        }
    }
    return -1;
}

/// Rows before of what a node touches; added ones count as those they stand behind.
std::vector<int> rows_about(int node, const TriMesh& mesh, std::span<const int> changed,
                            const std::vector<int>& stands_for) {
    std::vector<int> rows;
    for (const int t : changed) {
        const std::array<int, 3>& corners = mesh.triangles[at(t)];
        if (std::find(corners.begin(), corners.end(), node) == corners.end()) {
            continue;
        }
        for (const int other : corners) {
            if (stands_for[at(other)] >= 0) {
                rows.push_back(stands_for[at(other)]);
            }
        }
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

}  // namespace

std::optional<RowsWithAdded> with_added_nodes(const std::vector<int>& node_of, const std::vector<int>& row_of,
                                              const BlockPattern& pattern, const TriMesh& mesh,
                                              std::span<const int> changed) {
    const int nodes = static_cast<int>(mesh.nodes.size());
    const int known = static_cast<int>(node_of.size());
    std::vector<int> stands_for(row_of);  // per node: its row before, or the one that it stands behind
    stands_for.resize(at(nodes), -1);
    std::vector<std::pair<int, int>> added;  // row before, node
    for (int node = known; node < nodes; ++node) {
        const int row = common_row(pattern, rows_about(node, mesh, changed, stands_for));
        if (row < 0) {
            return std::nullopt;
        }
        stands_for[at(node)] = row;
        added.emplace_back(row, node);
    }
    std::sort(added.begin(), added.end());
    RowsWithAdded result;
    result.node_of.reserve(at(nodes));
    result.row_now.reserve(at(known));
    std::size_t next = 0;
    for (int row = 0; row < known; ++row) {
        result.row_now.push_back(static_cast<int>(result.node_of.size()));
        result.node_of.push_back(node_of[at(row)]);
        for (; next < added.size() && added[next].first == row; ++next) {
            result.node_of.push_back(added[next].second);
        }
    }
    result.row_of.resize(at(nodes));
    for (int row = 0; row < nodes; ++row) {
        result.row_of[at(result.node_of[at(row)])] = row;
    }
    return result;
}

}  // namespace rhexis
