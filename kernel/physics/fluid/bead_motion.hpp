// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: beads that forceps take, carry, lose and let go.
#pragma once

#include <span>

#include "flow/world.hpp"

namespace rhexis {

/// By one step of dt [s]. docs/beads.md has the formulas.
void move_beads(const WorldModel& world, std::span<const ToolState> tools, double dt, BeadsState& beads);

}  // namespace rhexis
