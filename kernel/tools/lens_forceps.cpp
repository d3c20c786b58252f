// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/lens_forceps.hpp"

#include "tools/bent_tool.hpp"

namespace rhexis {

ToolModel lens_forceps() {
    ToolModel tool = bent_tool("lens_forceps", 1.0, 0.15, 0.3);
    tool.kind = ToolKind::forceps;
    tool.friction = 0.2;
    tool.lens_reach = 0.6;  // proposal: half of a short platform
    tool.hold = 40000.0;    // proposal: as of those for the capsule
    return tool;
}

}  // namespace rhexis
