// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/spatula.hpp"

namespace rhexis {

ToolModel spatula() {
    constexpr double end = 0.20;
    constexpr double shaft = 0.25;
    constexpr double bend_at = 1.2;
    constexpr double bend = 0.25;  // sideways over bend_at
    constexpr double handle_start = 22.0;
    ToolModel tool;
    tool.name = "spatula";
    tool.kind = ToolKind::probe;
    tool.parts = {{Vec3(0.0, 0.0, end), Vec3(0.0, bend, bend_at), end, shaft},
                  {Vec3(0.0, bend, bend_at), Vec3(0.0, bend, handle_start), shaft, shaft},
                  {Vec3(0.0, bend, handle_start), Vec3(0.0, bend, 110.0), 1.5, 4.0}};
    tool.friction = 0.2;
    return tool;
}

}  // namespace rhexis
