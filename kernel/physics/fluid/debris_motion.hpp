// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: debris drifts with the fluid, sinks, stays within bag and eye, shuts a mouth or goes through it.
#pragma once

#include <span>

#include "flow/tool.hpp"
#include "flow/world.hpp"
#include "physics/fluid/mouth.hpp"

namespace rhexis {

/// One step of dt [s]. What is aspirated or emulsified is booked in the state as removed mass. Debris passes through
/// lens tissue.
void move_debris(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                 double dt, WorldState& state);

/// Whether it lies in a mouth that it is too wide for.
bool shuts(const Debris& debris, const ToolModel& tool, const Vec3& mouth);

}  // namespace rhexis
