// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/supernodes.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "base/index.hpp"

namespace rhexis {
namespace {

/// Rows below the diagonal of each column of the factor, ascending.
std::vector<std::vector<int>> column_rows(const BlockPattern& pattern) {
    const int n = pattern.rows();
    std::vector<std::vector<int>> rows(at(n));
    std::vector<std::vector<int>> children(at(n));
    for (int j = 0; j < n; ++j) {
        std::vector<int>& own = rows[at(j)];
        own.assign(pattern.column.begin() + pattern.diagonal[at(j)] + 1,
                   pattern.column.begin() + pattern.first[at(j) + 1]);
        for (const int child : children[at(j)]) {
            own.insert(own.end(), rows[at(child)].begin() + 1, rows[at(child)].end());
        }
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        if (!own.empty()) {
            children[at(own.front())].push_back(j);
        }
    }
    return rows;
}

struct Panel {
    int first = 0;
    int width = 0;
    std::vector<int> rows;
    double entries = 0.0;  ///< that the factor needs, without the zeros of merging
};

double stored(int width, std::size_t below) {
    return 0.5 * width * (width + 1) + static_cast<double>(width) * static_cast<double>(below);
}

/// Whether a panel may be merged into the one that starts where it ends.
bool worth_merging(const Panel& child, const Panel& parent) {
    if (child.rows.empty() || child.rows.front() != parent.first || child.first + child.width != parent.first) {
        return false;
    }
    const int width = child.width + parent.width;
    const double all = stored(width, parent.rows.size());
    const double zeros = (all - child.entries - parent.entries) / all;
    return width <= 4 ? zeros < 0.5 : width <= 16 ? zeros < 0.12 : zeros < 0.05;
}

std::vector<Panel> merged_panels(std::vector<std::vector<int>> rows) {
    std::vector<Panel> panels;
    for (int j = 0; j < static_cast<int>(rows.size()); ++j) {
        Panel next{j, 1, std::move(rows[at(j)]), 0.0};
        next.entries = stored(1, next.rows.size());
        while (!panels.empty() && worth_merging(panels.back(), next)) {
            next.first = panels.back().first;
            next.width += panels.back().width;
            next.entries += panels.back().entries;
            panels.pop_back();
        }
        panels.push_back(std::move(next));
    }
    return panels;
}

}  // namespace

Supernodes find_supernodes(const BlockPattern& pattern) {
    const std::vector<Panel> panels = merged_panels(column_rows(pattern));
    std::vector<int> panel_of(at(pattern.rows()));
    Supernodes result;
    result.row_first.push_back(0);
    for (std::size_t s = 0; s < panels.size(); ++s) {
        result.first.push_back(panels[s].first);
        std::fill_n(panel_of.begin() + panels[s].first, panels[s].width, static_cast<int>(s));
        result.row.insert(result.row.end(), panels[s].rows.begin(), panels[s].rows.end());
        result.row_first.push_back(static_cast<int>(result.row.size()));
    }
    result.first.push_back(pattern.rows());
    for (const Panel& panel : panels) {
        result.parent.push_back(panel.rows.empty() ? -1 : panel_of[at(panel.rows.front())]);
    }
    return result;
}

}  // namespace rhexis
