// SPDX-License-Identifier: GPL-3.0-or-later
// Where an instrument's tip and shaft lie in the frame of its markers, from poses turned about them.
#pragma once

#include <span>

#include "base/result.hpp"
#include "math/types.hpp"

namespace rhexis::tracking {

struct PivotSettings {
    int fewest_poses = 30;
    double least_spread_deg = 8.0;   ///< of the direction that turned least; see PivotCalibration
    double most_residual_mm = 0.5;   ///< beyond, the tip slipped
    double most_residual_deg = 1.0;  ///< beyond, the shaft did not turn about itself
    double least_spin_deg = 60.0;    ///< spread of the directions across the shaft
};

struct PivotCalibration {
    Vec3 tip = Vec3::Zero();    ///< in the body's frame [mm]
    Vec3 pivot = Vec3::Zero();  ///< the fixed point, in the frame of the poses [mm]
    double residual_mm = 0.0;   ///< root mean square of the distance from the tip to the pivot
    double tip_sigma_mm = 0.0;  ///< standard deviation of the tip's place, from the residual
    double condition = 0.0;     ///< greatest by least singular value of the equations
    /// Of all directions of the body, the one that turned least: root mean square of its angle to its mean [degrees].
    /// About half of the half angle, when the shaft swings evenly through a cone.
    double spread_deg = 0.0;
};

/// The tip rests in a small hollow while the hand swings through a cone: R_i tip + p_i = pivot for all poses, linear
/// least squares ([Yaniv2015], the algebraic one step). Refused: too few poses, too little turning (how much there was
/// and is needed), or a tip that slipped.
Result<PivotCalibration> calibrate_pivot(std::span<const Pose> poses, const PivotSettings& settings = {});

struct ShaftCalibration {
    Vec3 axis = Vec3::UnitZ();  ///< unit direction in the body's frame
    double residual_deg = 0.0;  ///< root mean square of its angle to its mean in space
    double spread_deg = 0.0;    ///< of the directions across it, as PivotCalibration::spread_deg
};

/// The instrument lies in a groove and is turned about its shaft: the axis is the direction that all poses turn least,
/// the greatest singular vector of the mean rotation. Of its two ends the one is taken that looks towards `to_hand`, a
/// vector of the body's frame. Refused as calibrate_pivot() does.
Result<ShaftCalibration> calibrate_shaft(std::span<const Pose> poses, const Vec3& to_hand,
                                         const PivotSettings& settings = {});

/// The tip's pose in the body, as MarkerBody has it: z along the axis, x as near to `side` as can be. `side` does not
/// lie along the axis.
Pose tip_pose(const Vec3& tip, const Vec3& axis, const Vec3& side);

}  // namespace rhexis::tracking
