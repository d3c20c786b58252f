// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/debris.hpp"

#include "math/roots.hpp"

namespace rhexis {

double radius_of(const Debris& debris) { return cube_root(0.238732414637843 * debris.volume); }  // 3 / (4 pi)

}  // namespace rhexis
