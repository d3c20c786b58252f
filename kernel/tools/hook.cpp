// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/hook.hpp"

#include "tools/bent_tool.hpp"

namespace rhexis {

ToolModel hook() {
    ToolModel tool = bent_tool("hook", 0.5, 0.1, 0.15);
    tool.kind = ToolKind::probe;
    tool.friction = 0.2;
    return tool;
}

}  // namespace rhexis
