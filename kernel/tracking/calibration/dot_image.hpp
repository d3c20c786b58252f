// SPDX-License-Identifier: GPL-3.0-or-later
// How a flat dot is seen: its image is an ellipse, whose middle is not where the dot's centre is seen.
#pragma once

#include "tracking/camera.hpp"

namespace rhexis::tracking {

/// From the image of a dot's centre to the middle of the dot's image [pixels] [Heikkila2000]. `board`: in the camera's
/// frame, the dot lies in its plane z = 0 at `on_board` [mm] and is wholly before the camera.
Vec2 dot_off(const Lens& lens, const Pose& board, const Vec2& on_board, double radius_mm);

/// The radius of a dot whose image has this area [pixels], small against its distance.
double dot_radius(const Lens& lens, const Pose& board, const Vec2& on_board, double area);

}  // namespace rhexis::tracking
