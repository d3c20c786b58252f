// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/probe.hpp"

#include "base/assert.hpp"

namespace rhexis {

ToolModel probe(double radius, double length) {
    RHEXIS_ASSERT(radius >= 0.05 && radius <= 5.0 && length >= 0.0);
    ToolModel tool;
    tool.name = "probe";
    tool.kind = ToolKind::probe;
    tool.parts = {{Vec3(0.0, 0.0, radius), Vec3(0.0, 0.0, radius + length), radius, radius}};
    tool.friction = 0.2;
    return tool;
}

}  // namespace rhexis
