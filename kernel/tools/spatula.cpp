// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/spatula.hpp"

namespace rhexis {

ToolModel spatula() {
    constexpr double end = 0.35;
    constexpr double neck = 0.22;
    constexpr double shaft = 0.25;
    constexpr double crossing = 8.0;  // where the shaft's axis crosses the z axis: about where the wound is
    constexpr double handle_start = 22.0;
    const Vec3 along(0.0, 0.82, 0.57236352085016735);  // of the end, from its tip: 55 degrees off the z axis
    const Vec3 bend = 2.5 * along;
    const Vec3 back = (Vec3(0.0, 0.0, crossing) - bend).normalized();
    const Vec3 handle = bend + handle_start * back;
    ToolModel tool;
    tool.name = "spatula";
    tool.kind = ToolKind::probe;
    tool.parts = {{end * along, 0.9 * along, end, end},
                  {0.9 * along, bend, neck, shaft},
                  {bend, handle, shaft, shaft},
                  {handle, bend + 110.0 * back, 1.5, 4.0}};
    tool.friction = 0.2;
    return tool;
}

}  // namespace rhexis
