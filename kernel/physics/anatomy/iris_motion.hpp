// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the iris goes with the diaphragm, its edge is caught by a mouth that sucks, stretched, and let go.
#pragma once

#include <span>

#include "flow/tool.hpp"
#include "flow/world.hpp"
#include "physics/fluid/mouth.hpp"

namespace rhexis {

/// One step; reads tips and chamber of `state` as they are now. A captured edge follows the mouth. It slips off when it
/// pulls harder than the suction holds, and tears beyond the strain that it bears.
void move_iris(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes, double dt,
               WorldState& state);

}  // namespace rhexis
