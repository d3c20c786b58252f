// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cutter.hpp"

namespace rhexis {

ToolModel cutter() {
    constexpr double outer = 0.32;
    constexpr double sleeve = 0.6;
    constexpr double sleeve_start = 3.0;
    constexpr double handle_start = 18.0;
    ToolModel tool;
    tool.name = "cutter";
    tool.kind = ToolKind::cutter;
    tool.parts = {{Vec3(0.0, 0.0, outer), Vec3(0.0, 0.0, sleeve_start), outer, outer},
                  {Vec3(0.0, 0.0, sleeve_start + sleeve), Vec3(0.0, 0.0, handle_start), sleeve, sleeve},
                  {Vec3(0.0, 0.0, handle_start), Vec3(0.0, 0.0, 120.0), 2.0, 6.0}};
    tool.friction = 0.2;
    tool.bore_radius = 0.2;
    tool.edge_radius = 0.1;
    return tool;
}

}  // namespace rhexis
