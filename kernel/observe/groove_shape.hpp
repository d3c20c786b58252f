// SPDX-License-Identifier: GPL-3.0-or-later
// The groove as a shape, read from what is missing in the columns of the lens: the largest connected patch of columns
// that have lost tissue.
#pragma once

#include "observe/lens_columns.hpp"

namespace rhexis {

/// A column belongs to a groove from this loss on [mm]: less is a scratch, about half a fine tetrahedron.
constexpr double footprint_loss = 0.2;

struct GrooveShape {
    bool exists = false;
    double depth = 0.0;              ///< greatest depth below the front surface [mm], see local_depth
    double depth_share = 0.0;        ///< greatest share of the local thickness
    double mean_depth = 0.0;         ///< mean over the length of the depth of the floor [mm]
    double mean_depth_share = 0.0;   ///< likewise, share of the local thickness
    double length = 0.0;             ///< along its own direction [mm]
    double width = 0.0;              ///< mean across it: area over length [mm]
    Vec2 direction = Vec2::UnitY();  ///< unit, pointing away from the surgeon (+y)
    Vec3 near_end = Vec3::Zero();    ///< where it begins on the front surface, surgeon's side, at rest [mm]
    Vec3 far_end = Vec3::Zero();     ///< where it ends [mm]
    Vec3 floor = Vec3::Zero();       ///< its deepest place, at rest [mm]
};

/// Depth of a column that counts for the groove: the length of tissue gone, as the median over the 3 x 3 columns around
/// it, so that one odd tetrahedron does not pass for a depth. [mm]
double local_depth(const ColumnGrid& grid, const ColumnFill& fill, int cell);

/// In which these cells (at least one) spread most; unit, pointing to +y.
Vec2 principal_direction(const ColumnGrid& grid, const std::vector<int>& cells);

/// The shape of the groove that takes up these cells (ascending) and runs in a direction (unit); `depth_cells`: the
/// part of them whose depth counts.
GrooveShape shape_of(const ColumnGrid& grid, const ColumnFill& fill, const std::vector<int>& cells,
                     const std::vector<int>& depth_cells, const Vec2& direction);

/// Of the largest connected patch.
GrooveShape groove_shape(const ColumnGrid& grid, const ColumnFill& fill);

}  // namespace rhexis
