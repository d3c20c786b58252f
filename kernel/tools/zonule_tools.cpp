// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/zonule_tools.hpp"

#include "tools/bent_tool.hpp"

namespace rhexis {

ToolModel capsule_hook() {
    ToolModel tool = bent_tool("capsule_hook", 0.5, 0.08, 0.12);
    tool.kind = ToolKind::capsule_hook;
    tool.friction = 0.1;
    return tool;
}

ToolModel tension_ring() {
    ToolModel tool = bent_tool("ring", 0.5, 0.1, 0.3);
    tool.kind = ToolKind::ring;
    tool.friction = 0.1;
    return tool;
}

}  // namespace rhexis
