// SPDX-License-Identifier: GPL-3.0-or-later
// Angles about the z axis without the C library's trigonometry, so that the bits do not depend on it.
#pragma once

#include "math/types.hpp"

namespace rhexis {

/// (cos, sin) of an angle [rad], |angle| < 7, to 1e-8.
Vec2 direction_at(double angle);

/// Increases with the angle of (x, y) about the axis, from 0 to 1 for a whole turn, but not evenly.
double share_of_turn(const Vec3& place);

}  // namespace rhexis
