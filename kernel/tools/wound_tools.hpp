// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments that make wounds, shut them and test them.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// A blade of 2.4 mm with a point of 1.5 mm. [mm]
ToolModel keratome();

/// A blade of 1.0 mm, for the side port.
ToolModel side_port_blade();

/// A blunt cannula of 27 gauge; saline comes out of its end.
ToolModel hydration_cannula();

/// It holds a curved needle with a thread, whose point is the tip.
ToolModel needle_holder();

/// A swab of cellulose, with a round end of 0.8 mm radius.
ToolModel sponge();

}  // namespace rhexis
