// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: how blades cut wounds, and how tips peel Descemet's membrane. docs/wounds.md has the formulas.
#pragma once

#include <span>

#include "flow/tool.hpp"
#include "flow/world.hpp"

namespace rhexis {

/// One step: blades go through the cornea, and what is pushed against an inner lip peels it.
void cut_wounds(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state);

}  // namespace rhexis
