// SPDX-License-Identifier: GPL-3.0-or-later
// The lens at rest cut into vertical columns, so that what was sculpted away can be read as depth and as light: each
// column knows, front to back, which fine tetrahedra it passes and how far. Lengths are exact chords, not samples.
#pragma once

#include <span>
#include <vector>

#include "flow/solid.hpp"

namespace rhexis {

/// One fine tetrahedron on the way of a column.
struct ColumnSegment {
    int tet = 0;
    int material = 0;
    double low = 0.0;   ///< [mm], at rest
    double high = 0.0;  ///< [mm], at rest
};

/// Constant: the columns of a lens at rest, on a square grid across the view axis.
struct ColumnGrid {
    double cell = 0.2;                    ///< spacing [mm]
    int count = 0;                        ///< cells per side
    double origin = 0.0;                  ///< x and y of the centre of cell 0 [mm]
    std::vector<int> first;               ///< per cell: its first segment; one more at the end
    std::vector<ColumnSegment> segments;  ///< front to back within a cell
    std::vector<double> front;            ///< per cell: front surface [mm]; NaN outside the lens
    std::vector<double> back;             ///< per cell: back surface [mm]; NaN outside the lens

    [[nodiscard]] int cells() const { return count * count; }
    [[nodiscard]] Vec2 centre(int index) const {
        const int row = index / count;
        return {origin + (index % count) * cell, origin + row * cell};
    }
    /// The cell that holds a place, or -1 outside the grid.
    [[nodiscard]] int cell_at(const Vec2& place) const {
        const double x = (place.x() - origin) / cell + 0.5;
        const double y = (place.y() - origin) / cell + 0.5;
        return x >= 0.0 && y >= 0.0 && x < count && y < count ? static_cast<int>(y) * count + static_cast<int>(x) : -1;
    }
    [[nodiscard]] bool inside(int index) const { return index >= 0 && first[index] != first[index + 1]; }
    [[nodiscard]] double thickness(int index) const { return front[index] - back[index]; }
};

/// cell: spacing [mm], > 0.
ColumnGrid make_columns(const SolidModel& lens, double cell);

/// Front surface at rest at a place, bilinear between columns [mm]; NaN outside the lens.
double front_surface(const ColumnGrid& grid, const Vec2& place);
/// Back surface at rest, likewise.
double back_surface(const ColumnGrid& grid, const Vec2& place);

/// What is left in each column: follows from the fractions alone.
struct ColumnFill {
    std::vector<double> fraction;      ///< the fractions that this was made from
    std::vector<double> removed;       ///< per cell: length of tissue that is gone [mm]
    std::vector<double> bottom;        ///< per cell: depth below the front of the deepest mostly removed tissue [mm]
    std::vector<Vec3> transmission;    ///< per cell: exp(-optical depth), red, green, blue
    double removed_volume = 0.0;       ///< at rest [mm^3]
    std::vector<double> fine_volumes;  ///< of each fine tetrahedron at rest [mm^3]
};

/// Brings `fill` up to date; does nothing while the fractions stay the same. True when it changed.
bool update_columns(const SolidModel& lens, const ColumnGrid& grid, const std::vector<double>& fraction,
                    ColumnFill& fill);

}  // namespace rhexis
