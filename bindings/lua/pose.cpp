// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/pose.hpp"

#include <numbers>

#include "math/rotation.hpp"

namespace rhexis::lua {

void read_pose(lua_State* L, Options& options, Pose& pose) {
    pose.position = options.vec3("position", pose.position);
    const bool turned = options.has("axis") || options.has("roll");
    const Vec3 axis = options.vec3("axis", tool_axis(pose));
    const double roll = options.number("roll", 0.0, {-360.0, 360.0, "degrees"});
    if (axis.norm() < 1e-9) {
        push(L, axis);
        options.fail("axis", "allowed: a direction, not all zero");
    }
    if (turned) {
        const Eigen::AngleAxisd about_shaft(roll * std::numbers::pi / 180.0, Vec3::UnitZ());
        pose.orientation = turn_of_z(axis) * Quat(about_shaft);
        pose.orientation.normalize();
    }
}

Vec3 tool_axis(const Pose& pose) { return pose.orientation * Vec3::UnitZ(); }

}  // namespace rhexis::lua
