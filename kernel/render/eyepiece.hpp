// SPDX-License-Identifier: GPL-3.0-or-later
// What the optics of a microscope do to a sharp picture.
#pragma once

#include "flow/frame.hpp"

namespace rhexis {

/// Blurs the picture by camera.blur_mm, all of it alike, and darkens what lies outside of a circle of camera.stop_mm
/// about its middle; 0 leaves it as it is.
void look_through_eyepiece(const Camera& camera, Image& image);

}  // namespace rhexis
