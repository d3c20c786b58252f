// SPDX-License-Identifier: GPL-3.0-or-later
// The opening that a capsulorhexis left, as a bag without its lens takes it over: how far its edge is from the axis.
#pragma once

#include <vector>

#include "base/result.hpp"
#include "flow/membrane.hpp"

namespace rhexis {

/// Directions in which an opening is measured, from +x on evenly.
inline constexpr int opening_directions = 64;

/// Distance of a closed polygon from the axis, at z = 0, in each of `count` directions [mm]. The edge is straight
/// between its points; where it goes back on itself, as seen from the axis, its outermost place counts. Fails where the
/// polygon does not go round the axis.
Result<std::vector<double>> ring_radii(const std::vector<Vec2>& ring, int count = opening_directions);

/// The same of the opening in an anterior capsule, at rest, as seen along the axis and without the slits that go off
/// from its rim. Fails where nothing is open, the tear has not come round, or a tear has run out to the zonules.
Result<std::vector<double>> opening_radii(const MembraneModel& model, const MembraneState& state);

}  // namespace rhexis
