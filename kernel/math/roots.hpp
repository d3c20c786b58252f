// SPDX-License-Identifier: GPL-3.0-or-later
// Roots with the same bits on every machine, which a library's need not have.
#pragma once

namespace rhexis {

/// x >= 0; of a negative number or NaN 0.
double cube_root(double x);

/// Of a ball of that volume.
double ball_radius(double volume);

}  // namespace rhexis
