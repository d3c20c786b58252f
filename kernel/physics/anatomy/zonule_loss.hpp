// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: zonules that are stretched too far, and what a hand sets in their place. docs/zonules.md has the
// formulas.
#pragma once

#include <span>
#include <vector>

#include "flow/bag.hpp"
#include "flow/tool.hpp"

namespace rhexis {

/// Distance of a place in the bag's frame from the edge of its opening [mm].
double distance_to_rim(const BagModel& bag, const Vec3& place);

/// After the bag has moved: the most stretched zonule breaks if it is stretched too far, one a step, so that the others
/// take over its load before the next does; a hook stays where the hand lets go of it on the edge of the opening; a
/// ring is fed in there. The bag's model and state must have zonules that can break.
void tend_zonules(const BagModel& bag, std::span<const ToolModel> models, std::span<const ToolState> tools, double dt,
                  BagState& state);

}  // namespace rhexis
