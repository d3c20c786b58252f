// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/bag_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/turn.hpp"

namespace rhexis {

namespace {

Vec2 direction_of(const BagCells& cells, int sector) {
    return direction_at(2.0 * std::numbers::pi * (sector + 0.5) / cells.sectors);
}

}  // namespace

int cell_count(const BagCells& cells) { return cells.sectors * cells.rings; }

int cell_at(const BagCells& cells, const Vec2& place) {
    const double share = place.squaredNorm() / (cells.radius * cells.radius);
    const int ring = std::clamp(static_cast<int>(std::min(share, 1.0) * cells.rings), 0, cells.rings - 1);
    int best = 0;
    for (int sector = 1; sector < cells.sectors; ++sector) {
        best = direction_of(cells, sector).dot(place) > direction_of(cells, best).dot(place) ? sector : best;
    }
    return best * cells.rings + ring;
}

Vec2 cell_middle(const BagCells& cells, int cell) {
    const int ring = cell % cells.rings;
    return cells.radius * std::sqrt((ring + 0.5) / cells.rings) * direction_of(cells, cell / cells.rings);
}

}  // namespace rhexis
