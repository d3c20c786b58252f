// SPDX-License-Identifier: GPL-3.0-or-later
// A lens that is no solid: the smooth rigid body under its capsule, as the picture sees it.
#pragma once

#include <optional>
#include <vector>

#include "flow/frame.hpp"
#include "render/signed_faces.hpp"

namespace rhexis {

struct StillLens {
    BagShape shape;     ///< contour, where it rests
    double lift = 0.0;  ///< along z, from there [mm]
    std::array<LensZone, 3> zones;
};

/// What the first membrane with a support lies on, or the lens of an eye of which only the front takes part; none where
/// solids show instead, or in a bare scene.
std::optional<StillLens> still_lens(const Frame& frame);

/// Appends the borders of its zones.
void append_signed_faces(const StillLens& lens, FaceStream& stream);

/// Appends the corners of its contour's triangles: place now, and place at rest (3 floats each) [mm].
void append_front(const StillLens& lens, std::vector<float>& stream);

/// Radius, anterior, posterior of the contour [mm]; zero where there is no such lens.
Vec3 contour_of(const std::optional<StillLens>& lens);

}  // namespace rhexis
