// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: viscoelastic that comes out of a cannula and leaks along instruments, and what its pressure does to
// the lens.
#pragma once

#include <span>

#include "flow/world.hpp"

namespace rhexis {

/// By one step of dt [s]. Lenses under membranes are pushed by what the chamber lacks against the vitreous.
void fill_chamber(const WorldModel& world, std::span<const ToolState> tools, double dt, WorldState& state);

}  // namespace rhexis
