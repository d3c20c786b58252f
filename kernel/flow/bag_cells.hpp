// SPDX-License-Identifier: GPL-3.0-or-later
// The bag as the microscope shows it, cut into cells of equal area: sectors of equal angle, rings of equal area.
#pragma once

#include "math/types.hpp"

namespace rhexis {

struct BagCells {
    int sectors = 24;
    int rings = 4;
    double radius = 4.6;  ///< of the bag [mm]
};

int cell_count(const BagCells& cells);

/// Number of the cell at a place across the axis; outside the bag that of its edge. sector * rings + ring.
int cell_at(const BagCells& cells, const Vec2& place);

/// Middle of a cell, across the axis [mm].
Vec2 cell_middle(const BagCells& cells, int cell);

}  // namespace rhexis
