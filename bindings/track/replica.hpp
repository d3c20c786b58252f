// SPDX-License-Identifier: GPL-3.0-or-later
// Replicas of instruments: the shape that is drawn, as what is printed and held.
#pragma once

#include <string>

#include "base/result.hpp"
#include "render/tool_mesh.hpp"
#include "tracking/print/marker_body_stl.hpp"

namespace rhexis::tracking {

/// By name: one that operates, or one of assets/instruments that is only drawn. The error suggests the nearest name.
Result<ToolMesh> instrument_mesh(const std::string& name);

/// Its handle, and its shape with closed jaws, in closed shells; openings are closed.
Result<Replica> replica_of(const std::string& name);

}  // namespace rhexis::tracking
