// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the iris is pushed into the main wound, stays there, slips back, or is pushed back.
#pragma once

#include <span>

#include "flow/tool.hpp"
#include "flow/world.hpp"

namespace rhexis {

/// One step, after the iris has moved with its chamber; the pupil of `state` narrows by what is drawn out.
void move_prolapse(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state);

/// Length after one implicit step of dt [s] under the pressure `pull` [Pa] over a wound of this width [mm].
double pushed_length(const ProlapseModel& model, const ProlapseState& state, double pull, double width, double dt);

}  // namespace rhexis
