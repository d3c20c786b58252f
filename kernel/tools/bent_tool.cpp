// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/bent_tool.hpp"

namespace rhexis {
namespace {

constexpr double shaft_fall = 0.1;  ///< up per length towards the hand

Vec3 towards_hand() { return Vec3(0.0, -1.0, shaft_fall).normalized(); }

constexpr double bent_tool_length = 26.0;
constexpr double handle_length = 110.0;

}  // namespace

ToolModel bent_tool(const char* name, double length, double point, double shaft) {
    const Vec3 bend(0.0, 0.0, length);
    const Vec3 back = bend + bent_tool_length * towards_hand();
    ToolModel tool;
    tool.name = name;
    tool.parts = {{Vec3(0.0, 0.0, point), bend, point, shaft},
                  {bend, back, shaft, shaft},
                  {back, bend + handle_length * towards_hand(), 1.5, 4.0}};
    return tool;
}

}  // namespace rhexis
