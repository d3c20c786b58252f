// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/debris.hpp"

#include "math/roots.hpp"

namespace rhexis {

double radius_of(const Debris& debris) { return ball_radius(debris.volume); }

}  // namespace rhexis
