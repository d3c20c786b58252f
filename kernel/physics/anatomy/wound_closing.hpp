// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: what holds wounds shut, what they leak, and what else comes into the eye with them.
// docs/wounds.md has the formulas.
#pragma once

#include <span>

#include "flow/tool.hpp"
#include "flow/world.hpp"

namespace rhexis {

/// Along the lips of a wound, unit; and from its outer lip away from the axis.
Vec3 along_lip(const Wound& wound);
Vec3 across_lip(const Wound& wound);

/// Before the fluid moves: hydration, stitches, a sponge; what syringes and the choroid give. The eye's volume grows.
void close_wounds(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state);

/// What all wounds and the instruments in them let through, share of the chamber's leak_conductance.
double wounds_open(const WorldModel& model, std::span<const ToolState> tools, const WorldState& state);

/// After the fluid has moved: what came through each wound, what lies on it, and what a test of it shows.
void share_leak(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state);

}  // namespace rhexis
