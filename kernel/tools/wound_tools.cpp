// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/wound_tools.hpp"

namespace rhexis {
namespace {

ToolModel blade(const char* name, double width, double point) {
    constexpr double edge = 0.03;
    constexpr double neck = 6.0;
    constexpr double handle = 16.0;
    ToolModel tool;
    tool.name = name;
    tool.kind = ToolKind::blade;
    tool.blade_width = width;
    tool.blade_point = point;
    const double body = 0.2 * width;
    tool.parts = {{Vec3(0.0, 0.0, edge), Vec3(0.0, 0.0, point), edge, body},
                  {Vec3(0.0, 0.0, point), Vec3(0.0, 0.0, neck), body, body},
                  {Vec3(0.0, 0.0, neck), Vec3(0.0, 0.0, handle), body, 1.0},
                  {Vec3(0.0, 0.0, handle), Vec3(0.0, 0.0, 120.0), 2.5, 3.5}};
    tool.friction = 0.1;
    return tool;
}

}  // namespace

ToolModel keratome() { return blade("keratome", 2.4, 1.5); }

ToolModel side_port_blade() { return blade("side_port_blade", 1.0, 1.2); }

ToolModel hydration_cannula() {
    constexpr double radius = 0.2;
    constexpr double hub = 22.0;
    ToolModel tool;
    tool.name = "hydration_cannula";
    tool.kind = ToolKind::hydrator;
    tool.parts = {{Vec3(0.0, 0.0, radius), Vec3(0.0, 0.0, hub), radius, radius},
                  {Vec3(0.0, 0.0, hub), Vec3(0.0, 0.0, 120.0), 2.0, 5.0}};
    tool.friction = 0.1;
    return tool;
}

ToolModel needle_holder() {
    constexpr double needle = 0.08;
    constexpr double held_at = 4.0;
    ToolModel tool;
    tool.name = "needle_holder";
    tool.kind = ToolKind::needle;
    tool.parts = {{Vec3(0.0, 0.0, needle), Vec3(0.0, 0.6, 2.0), needle, needle},
                  {Vec3(0.0, 0.6, 2.0), Vec3(0.0, 0.0, held_at), needle, needle},
                  {Vec3(0.0, 0.0, held_at), Vec3(0.0, 0.0, 20.0), 0.4, 1.0},
                  {Vec3(0.0, 0.0, 20.0), Vec3(0.0, 0.0, 120.0), 2.5, 4.0}};
    tool.friction = 0.1;
    return tool;
}

ToolModel sponge() {
    constexpr double end = 0.8;
    ToolModel tool;
    tool.name = "sponge";
    tool.kind = ToolKind::sponge;
    tool.parts = {{Vec3(0.0, 0.0, end), Vec3(0.0, 0.0, 6.0), end, 1.6},
                  {Vec3(0.0, 0.0, 6.0), Vec3(0.0, 0.0, 120.0), 1.0, 1.2}};
    tool.friction = 0.3;
    return tool;
}

}  // namespace rhexis
