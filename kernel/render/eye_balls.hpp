// SPDX-License-Identifier: GPL-3.0-or-later
// The wall of an eye as a picture has it: balls of cornea and sclera.
#pragma once

#include <cmath>

#include "flow/frame.hpp"
#include "render/view.hpp"

namespace rhexis {

/// Centre and radius.
inline Vec4 cornea_ball(const EyeAnatomy& eye) {
    return {0.0, 0.0, eye.cornea_apex_z - eye.cornea_radius, eye.cornea_radius};
}

inline Vec4 cornea_back_ball(const EyeAnatomy& eye) {
    return {0.0, 0.0, eye.cornea_apex_z - eye.cornea_thickness - eye.cornea_back_radius, eye.cornea_back_radius};
}

inline Vec4 globe_ball(const EyeAnatomy& eye) {
    const double rise = std::sqrt(eye.globe_radius * eye.globe_radius - eye.limbus_radius * eye.limbus_radius);
    return {0.0, 0.0, eye.limbus_z - rise, eye.globe_radius};
}

}  // namespace rhexis
