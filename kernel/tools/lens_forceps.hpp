// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// Smooth angled forceps for an implant, as of Kelman and McPherson: platforms of 1.2 mm that close on a haptic, and
/// have no teeth to hold a capsule with. Tip at the origin, shaft towards -y.
ToolModel lens_forceps();

}  // namespace rhexis
