// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/rhexis_tools.hpp"

#include "tools/bent_tool.hpp"

namespace rhexis {

ToolModel cystotome() {
    ToolModel tool = bent_tool("cystotome", 1.0, 0.12, 0.2);
    tool.kind = ToolKind::cystotome;
    tool.cutting = 0.18;  // proposal: it cuts at about 3 mN
    tool.hold = 40000.0;  // proposal
    tool.friction = 0.2;
    return tool;
}

ToolModel capsulorhexis_forceps() {
    ToolModel tool = bent_tool("forceps", 1.0, 0.1, 0.3);
    tool.kind = ToolKind::forceps;
    tool.friction = 0.3;
    tool.reach = 0.3;
    tool.lens_reach = 0.3;
    tool.hold = 40000.0;  // proposal: twice the greatest force of a tear
    return tool;
}

ToolModel viscoelastic_cannula() {
    ToolModel tool = bent_tool("cannula", 0.6, 0.2, 0.2);
    tool.kind = ToolKind::cannula;
    tool.friction = 0.1;
    return tool;
}

ToolModel triamcinolone_cannula() {
    ToolModel tool = viscoelastic_cannula();
    tool.name = "triamcinolone";
    tool.stains = true;
    return tool;
}

ToolModel saline_cannula() {
    ToolModel tool = viscoelastic_cannula();
    tool.name = "saline_cannula";
    tool.saline = true;
    return tool;
}

}  // namespace rhexis
