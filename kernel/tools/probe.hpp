// SPDX-License-Identifier: GPL-3.0-or-later
// A blunt rod that only pushes.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// Rod with a round end. radius [mm], 0.05 to 5; length [mm] of the rod behind its end's centre, 0: a ball. The end's
/// foremost point is the origin, the rod runs along +z.
ToolModel probe(double radius, double length);

}  // namespace rhexis
