// SPDX-License-Identifier: GPL-3.0-or-later
// A point from the directions in which two or more cameras see it.
#pragma once

#include <optional>
#include <span>

#include "tracking/camera.hpp"

namespace rhexis::tracking {

/// One camera's view of a point.
struct View {
    int camera = 0;          ///< index in the rig
    int spot = 0;            ///< index among that camera's spots
    Vec2 at = Vec2::Zero();  ///< [pixels]
};

struct Triangulated {
    Vec3 point = Vec3::Zero();  ///< in the rig [mm]
    double residual_px = 0.0;   ///< root mean square over the views
};

/// The point nearest to all rays, then two Gauss-Newton steps on the images. None: fewer than two views, rays that are
/// parallel within 1 degree, or a point behind a camera.
std::optional<Triangulated> triangulate(std::span<const Camera> cameras, std::span<const View> views);

}  // namespace rhexis::tracking
