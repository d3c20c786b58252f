// SPDX-License-Identifier: GPL-3.0-or-later
// What a fitted outline makes of a sphere, without an image of it: as of spots/outline.hpp, of which it has the rays.
#pragma once

#include <optional>

#include "tracking/synthetic/seen_scene.hpp"
#include "tracking/synthetic/true_camera.hpp"

namespace rhexis::tracking::synthetic {

/// Measured on this folder's images, of spots of 18 to 26 pixels' width.
struct OutlineNoise {
    double ray_px = 0.053;  ///< standard deviation of one ray's rim that the place within a pixel leaves
    double shot = 1.0;      ///< times the sensor's noise at the rim, by the slope of light there
    double worn_px = 0.30;  ///< by which a patch at the rim that gives a third of its light moves the centre, some way
    double hidden_px = 0.05;    ///< likewise what hides a part of it, for each fifth of the rim that is hidden
    double inside_px = 0.19;    ///< by which the fitted outline is narrower each way than the sphere's image
    double least_light = 10.0;  ///< of a rim that is seen [DN]
};

struct MarkerOutline {
    Vec2 shift = Vec2::Zero();  ///< of the centre, the same as long as the view is [pixels]
    double sigma_px = 0.0;      ///< of the centre each way, drawn anew for each image
    double share = 1.0;         ///< of rays that show the rim
};

/// `middle_light`: of the sphere's middle in this camera [DN]. None: too little of the rim is seen to fit an outline.
std::optional<MarkerOutline> marker_outline(const TrueCamera& camera, const Scene& seen, int sphere,
                                            const Hiders& hiders, double middle_light, const OutlineNoise& noise);

}  // namespace rhexis::tracking::synthetic
