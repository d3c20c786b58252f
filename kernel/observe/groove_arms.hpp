// SPDX-License-Identifier: GPL-3.0-or-later
// Grooves that cross, told apart: each is a straight band of columns that have lost tissue. Found from what is missing
// alone, in the lens's own frame, so that turning the lens changes nothing.
//
// Over all directions, the rectangle is found that covers most lost columns and fewest whole ones; then, with the
// columns that it explains counting no more, the next. So again with slimness counting more, because the one that
// covers most may lie askew over the middle of a stout cross; the two that do best together are taken. In one direction
// the best rectangle follows from sums along rows and columns in turn, each time the stretch with the greatest sum.
// Where bands cross they share columns; the depth of each counts outside the others.
#pragma once

#include "observe/groove_shape.hpp"

namespace rhexis {

constexpr int most_grooves = 4;

/// A rectangle across the lens.
struct GrooveBand {
    Vec2 along = Vec2::UnitY();
    double low = 0.0;    ///< extent along [mm]
    double high = 0.0;   ///< [mm]
    double left = 0.0;   ///< extent across [mm]
    double right = 0.0;  ///< [mm]
    double worth = 0.0;  ///< lost columns, less what whole ones cost

    [[nodiscard]] double along_of(const Vec2& place) const { return place.dot(along); }
    [[nodiscard]] double across_of(const Vec2& place) const { return place.x() * along.y() - place.y() * along.x(); }
    /// Whether it holds a place when its sides are moved out by `more` [mm].
    [[nodiscard]] bool holds(const Vec2& place, double more) const {
        const double t = along_of(place);
        const double s = across_of(place);
        return t >= low - more && t <= high + more && s >= left - more && s <= right + more;
    }
};

class GrooveFinder {
public:
    /// Grooves, those with the greatest length times depth first; at most most_grooves. A groove is at least 2 mm long
    /// and clearly longer than wide: a pit is none. Always the same grid.
    std::vector<GrooveShape> find(const ColumnGrid& grid, const ColumnFill& fill);

private:
    // The bands follow from the columns that have lost tissue: kept until those change.
    std::vector<int> lost_;
    std::vector<GrooveBand> bands_;
    std::vector<std::vector<int>> turned_;  ///< of the grid alone: its columns along each direction that was tried
};

/// Smaller angle between two grooves, 0 to pi/2 [rad].
double angle_between(const GrooveShape& a, const GrooveShape& b);

}  // namespace rhexis
