// SPDX-License-Identifier: GPL-3.0-or-later
// The red reflex as brightness: light enters through the whole pupil, so its mean transmission scales what comes back,
// and leaves along the ray of the pixel. brightness = luminance of fundus * mean(exp(-tau)) * exp(-tau), over the same
// without a lens. (The view is taken as parallel to the axis: a microscope is far away.)
#pragma once

#include "observe/lens_columns.hpp"
#include "observe/lens_motion.hpp"

namespace rhexis {

/// Radius around the tip within which its brightness is judged [mm]: the tip itself hides the reflex.
inline constexpr double reflex_at_tip_mm = 0.6;

/// Light that comes back from the fundus, relative; red far above green and blue.
const Vec3& fundus_colour();

struct Reflex {
    Vec3 pupil_mean = Vec3::Ones();  ///< mean transmission over the pupil, red, green, blue
    double mean_brightness = 1.0;    ///< 0 dark to 1
};

Reflex reflex_of(const ColumnGrid& grid, const ColumnFill& fill, const LensMotion& motion, double pupil_radius);

/// Brightness around a place in the eye's frame: mean over the columns within `radius` [mm] that lie in the pupil; 0
/// outside the pupil.
double reflex_around(const Reflex& reflex, const ColumnGrid& grid, const ColumnFill& fill, const LensMotion& motion,
                     double pupil_radius, const Vec3& place, double radius);

}  // namespace rhexis
