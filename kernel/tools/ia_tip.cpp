// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/ia_tip.hpp"

namespace rhexis {

ToolModel ia_tip() {
    constexpr double outer = 0.4;
    constexpr double sleeve = 0.7;
    constexpr double sleeve_start = 2.0;
    constexpr double handle_start = 18.0;
    ToolModel tool;
    tool.name = "ia_tip";
    tool.kind = ToolKind::aspirator;
    tool.parts = {{Vec3(0.0, 0.0, outer), Vec3(0.0, 0.0, sleeve_start), outer, outer},
                  {Vec3(0.0, 0.0, sleeve_start + sleeve), Vec3(0.0, 0.0, handle_start), sleeve, sleeve},
                  {Vec3(0.0, 0.0, handle_start), Vec3(0.0, 0.0, 120.0), 2.0, 7.0}};
    tool.friction = 0.2;
    tool.bore_radius = 0.15;
    return tool;
}

}  // namespace rhexis
