// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/setup_tools.hpp"

#include "tools/bent_tool.hpp"

namespace rhexis {

ToolModel drape() {
    ToolModel tool = bent_tool("drape", 1.0, 0.6, 0.3);
    tool.kind = ToolKind::drape;
    return tool;
}

ToolModel speculum() {
    ToolModel tool = bent_tool("speculum", 1.0, 0.4, 0.4);
    tool.kind = ToolKind::speculum;
    return tool;
}

}  // namespace rhexis
