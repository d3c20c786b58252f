// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: cortex and viscoelastic that an aspirating mouth takes out of the bag. docs/bag_contents.md has the
// formulas.
#pragma once

#include <span>

#include "flow/tool.hpp"
#include "flow/world.hpp"
#include "physics/fluid/mouth.hpp"

namespace rhexis {

/// Before the chamber advances: which cortex lies before a mouth, and how that shuts it.
void look_for_cortex(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                     WorldState& state);

/// Once it has: what a mouth holds, strips and takes.
void strip_cortex(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                  double dt, WorldState& state);

/// Force and torque about the bag's centre of what pulls or sinks in it, besides what touches its wall.
Vec6 contents_load(const WorldModel& model, const WorldState& state, const Pose& bag);

/// What mouths and irrigation take of the viscoelastic.
void remove_viscoelastic(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                         double dt, WorldState& state);

}  // namespace rhexis
