// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: lids that a speculum opens, lashes that a drape covers, and a pedal that is tested in the air.
#pragma once

#include <span>

#include "flow/world.hpp"

namespace rhexis {

/// By one step of dt [s]. docs/setup.md has the formulas.
void move_lids(const WorldModel& world, std::span<const ToolState> tools, double dt, LidsState& lids);

}  // namespace rhexis
