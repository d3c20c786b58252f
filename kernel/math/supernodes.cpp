// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/supernodes.hpp"

#include <algorithm>

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

}  // namespace

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
