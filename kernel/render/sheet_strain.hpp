// SPDX-License-Identifier: GPL-3.0-or-later
// Where a thin sheet wrinkles: it is pulled one way and slack across it.
#pragma once

#include <vector>

#include "flow/membrane.hpp"

namespace rhexis {

/// Per node: how wrinkled, 0 to 1, times cosine and sine of twice the angle from x of the pull, seen along z; third
/// number 0. Twice the angle, because a pull has no sign and neighbours' are to be averaged.
std::vector<Vec3> wrinkles(const MembraneState& state);

}  // namespace rhexis
