// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of a sphere's image, from where its rim lies on rays from its middle. A part that is worn, hidden or too
// near to another bright thing is left out; the rest still tells where the centre is.
#pragma once

#include <array>
#include <optional>

#include "tracking/spot.hpp"

namespace rhexis::tracking {

inline constexpr int outline_rays = 64;

struct FittedOutline {
    Vec2 centre = Vec2::Zero();  ///< of the ellipse [pixels]
    double radius = 0.0;         ///< mean of its semi-axes [pixels]
    double stretch = 0.0;        ///< half their difference [pixels]
    double share = 0.0;          ///< of the rays whose rim lies on it, 0 to 1
    double sigma_px =
        0.0;  ///< standard deviation of the centre each way, by what the rim is off and how much of it counts
};

struct OutlineSettings {
    double least_step = 10.0;        ///< by which light falls at the rim [digital numbers]
    double least_step_share = 0.12;  ///< likewise, as a share of the spot's brightness
    double least_share = 0.55;       ///< of rays on the ellipse: fewer do not determine it
    double stretch_px = 0.4;         ///< standard deviation of `stretch` before anything is seen
};

/// Rim on each of outline_rays rays at even angles from `about`, no farther than 4 pixels inside and 5 outside of
/// `radius`: the outermost clear fall of light, where it is half way between inside and outside. Then the ellipse of
/// least squares with weights that fall with the residual [Beaton1974]. None: radius below 2.5 pixels, or too few rays
/// agree. `bright`: the spot's brightness above what is around [digital numbers].
std::optional<FittedOutline> fit_outline(const GreyImage& image, const Vec2& about, double radius, double bright,
                                         const OutlineSettings& settings);

}  // namespace rhexis::tracking
