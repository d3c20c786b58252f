// SPDX-License-Identifier: GPL-3.0-or-later
// How the lens as a whole has moved: the mass-weighted mean shift and the turn about the view axis.
#pragma once

#include <vector>

#include "flow/solid.hpp"

namespace rhexis {

struct LensMotion {
    Vec3 shift = Vec3::Zero();  ///< of the mean position [mm]
    Vec2 turn = Vec2::UnitX();  ///< cosine and sine of the turn about z

    /// A place in the eye's frame, as a place in the lens at rest (as if it were rigid).
    [[nodiscard]] Vec3 to_rest(const Vec3& place) const;
    /// The inverse.
    [[nodiscard]] Vec3 to_eye(const Vec3& rest) const;

    Vec3 centre = Vec3::Zero();  ///< of what is left, at rest [mm]
};

/// Volumes of the coarse tetrahedra at rest [mm^3]: constant weights of the mean.
std::vector<double> coarse_volumes(const SolidModel& lens);

/// Only tetrahedra that are still there count; no motion when none is.
LensMotion lens_motion(const SolidModel& lens, const std::vector<double>& volumes, const SolidState& state);

}  // namespace rhexis
