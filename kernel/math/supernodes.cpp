// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/supernodes.hpp"

#include <algorithm>
#include <utility>

#include "base/index.hpp"
#include "math/elimination_tree.hpp"

namespace rhexis {
namespace {

struct Panel {
    int first = 0;
    int width = 0;
    double entries = 0.0;  ///< that the factor needs, without the zeros of merging
};

double stored(int width, int below) { return 0.5 * width * (width + 1) + static_cast<double>(width) * below; }

/// Rows below the last column of a panel are those of all of it.
int below(const FactorRows& rows, const Panel& panel) {
    const std::size_t last = at(panel.first + panel.width - 1);
    return rows.first[last + 1] - rows.first[last];
}

/// Whether a panel may be merged into the one that starts where it ends.
bool worth_merging(const FactorRows& rows, const std::vector<int>& tree, const Panel& child, const Panel& parent) {
    if (tree[at(parent.first - 1)] != parent.first) {
        return false;
    }
    const int width = child.width + parent.width;
    const double all = stored(width, below(rows, parent));
    const double zeros = (all - child.entries - parent.entries) / all;
    return width <= 4 ? zeros < 0.5 : width <= 16 ? zeros < 0.12 : zeros < 0.05;
}

std::vector<Panel> merged_panels(const FactorRows& rows, const std::vector<int>& tree) {
    std::vector<Panel> panels;
    for (int j = 0; j < static_cast<int>(tree.size()); ++j) {
        Panel next{j, 1, 0.0};
        next.entries = stored(1, below(rows, next));
        while (!panels.empty() && worth_merging(rows, tree, panels.back(), next)) {
            next.first = panels.back().first;
            next.width += panels.back().width;
            next.entries += panels.back().entries;
            panels.pop_back();
        }
        panels.push_back(next);
    }
    return panels;
}

/// A row that a panel gets below it.
struct Below {
    int panel;
    int row;
};

/// Every panel with an entry in a row of a later one has that row below it, and so has every panel on the way there.
bool climb(const Supernodes& tree, const std::vector<int>& panel_of, int from, int row, std::vector<int>& met,
           std::vector<Below>& added) {
    int panel = panel_of[at(from)];
    for (; panel >= 0 && panel < panel_of[at(row)] && met[at(panel)] != row; panel = tree.parent[at(panel)]) {
        met[at(panel)] = row;
        added.push_back({panel, row});
    }
    return panel >= 0 && panel <= panel_of[at(row)];
}

bool reaches(const Supernodes& tree, int panel, int row) {
    const auto begin = tree.row.begin() + tree.row_first[at(panel)];
    const auto end = tree.row.begin() + tree.row_first[at(panel) + 1];
    return row < tree.first[at(panel) + 1] || std::binary_search(begin, end, row);
}

/// added: of each panel by ascending rows.
void merge_rows(Supernodes& tree, const std::vector<Below>& added) {
    std::vector<int> more(at(tree.count()) + 1, 0);  // where those of each panel start
    for (const Below& below : added) {
        ++more[at(below.panel) + 1];
    }
    for (std::size_t s = 0; s < at(tree.count()); ++s) {
        more[s + 1] += more[s];
    }
    std::vector<int> rows(added.size());
    std::vector<int> next(more.begin(), more.end() - 1);
    for (const Below& below : added) {
        rows[at(next[at(below.panel)]++)] = below.row;
    }
    std::vector<int> merged(tree.row.size() + rows.size());
    int* to = merged.data();
    for (std::size_t s = 0; s < at(tree.count()); ++s) {
        const int* const begin = tree.row.data() + tree.row_first[s];
        const int* const end = tree.row.data() + tree.row_first[s + 1];
        tree.row_first[s] += more[s];
        to = std::merge(begin, end, rows.data() + more[s], rows.data() + more[s + 1], to);
    }
    tree.row_first.back() += more.back();
    tree.row = std::move(merged);
}

}  // namespace

bool grow(Supernodes& tree, const BlockPattern& pattern, std::span<const int> row_now) {
    std::vector<int> panel_of(at(pattern.rows()));
    for (int& first : tree.first) {
        first = at(first) < row_now.size() ? row_now[at(first)] : pattern.rows();
    }
    for (int s = 0; s < tree.count(); ++s) {
        std::fill(panel_of.begin() + tree.first[at(s)], panel_of.begin() + tree.first[at(s) + 1], s);
    }
    for (int& row : tree.row) {
        row = row_now[at(row)];
    }
    std::vector<int> met(at(tree.count()), -1);
    std::vector<Below> added;
    const auto visit_new = [&](const auto& visit) {
        std::size_t known = 0;
        for (int row = 0; row < pattern.rows(); ++row) {
            if (known < row_now.size() && row_now[known] == row) {
                ++known;
                continue;
            }
            for (int slot = pattern.first[at(row)]; slot < pattern.first[at(row) + 1]; ++slot) {
                if (!visit(row, pattern.column[at(slot)])) {
                    return false;
                }
            }
        }
        return true;
    };
    const bool climbed = visit_new([&](int row, int column) {
        return panel_of[at(column)] >= panel_of[at(row)] || climb(tree, panel_of, column, row, met, added);
    });
    if (!climbed) {
        return false;
    }
    merge_rows(tree, added);
    return visit_new([&](int row, int column) { return column < row || reaches(tree, panel_of[at(row)], column); });
}

Supernodes find_supernodes(const BlockPattern& pattern) {
    const std::vector<int> tree = elimination_tree(pattern);
    const FactorRows rows = factor_rows(pattern, tree);
    const std::vector<Panel> panels = merged_panels(rows, tree);
    std::vector<int> panel_of(at(pattern.rows()));
    Supernodes result;
    result.row_first.push_back(0);
    for (std::size_t s = 0; s < panels.size(); ++s) {
        const int last = panels[s].first + panels[s].width - 1;
        result.first.push_back(panels[s].first);
        std::fill_n(panel_of.begin() + panels[s].first, panels[s].width, static_cast<int>(s));
        result.row.insert(result.row.end(), rows.row.begin() + rows.first[at(last)],
                          rows.row.begin() + rows.first[at(last) + 1]);
        result.row_first.push_back(static_cast<int>(result.row.size()));
    }
    result.first.push_back(pattern.rows());
    for (std::size_t s = 0; s < panels.size(); ++s) {
        const int parent = tree[at(panels[s].first + panels[s].width - 1)];
        result.parent.push_back(parent < 0 ? -1 : panel_of[at(parent)]);
    }
    return result;
}

}  // namespace rhexis
