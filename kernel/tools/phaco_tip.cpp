// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/phaco_tip.hpp"

namespace rhexis {

ToolModel phaco_tip() {
    constexpr double outer = 0.45;
    constexpr double sleeve = 0.75;
    constexpr double sleeve_start = 1.5;
    constexpr double handle_start = 18.0;
    ToolModel tool;
    tool.name = "phaco";
    tool.kind = ToolKind::phaco;
    tool.parts = {{Vec3(0.0, 0.0, outer), Vec3(0.0, 0.0, sleeve_start), outer, outer},
                  {Vec3(0.0, 0.0, sleeve_start + sleeve), Vec3(0.0, 0.0, handle_start), sleeve, sleeve},
                  {Vec3(0.0, 0.0, handle_start), Vec3(0.0, 0.0, 120.0), 2.0, 7.0}};
    tool.friction = 0.2;
    tool.bore_radius = 0.35;
    tool.edge_radius = 0.1;
    tool.bevel = 0.52359877559829887;  // 30 degrees
    tool.max_power = 600.0;
    return tool;
}

}  // namespace rhexis
