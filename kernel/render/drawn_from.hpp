// SPDX-License-Identifier: GPL-3.0-or-later
// From where something was drawn that is kept for the next picture, and what may change meanwhile without being seen.
#pragma once

#include "render/pixel_rect.hpp"
#include "render/view.hpp"

namespace rhexis {

/// Tissue that moves by less is not seen to move [mm].
inline constexpr double seen_mm = 2e-3;

struct DrawnFrom {
    Mat4 clip_from_world = Mat4::Zero();
    PixelRect area;
    Vec3 reference = Vec3::Zero();  ///< from which depths are measured
    bool operator==(const DrawnFrom& other) const {
        return clip_from_world == other.clip_from_world && area == other.area && reference == other.reference;
    }
};

}  // namespace rhexis
