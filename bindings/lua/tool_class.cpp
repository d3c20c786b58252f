// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid instrument of a scene, moved by the script.
#include <string>

#include "lua/guard.hpp"
#include "lua/modules.hpp"
#include "lua/objects.hpp"
#include "lua/pose.hpp"
#include "lua/stack.hpp"

namespace rhexis::lua {
namespace {

struct ToolPart {
    SceneBody& scene;
    int index;
    const ToolModel& model;
    const ToolState& state;
};

ToolPart check_tool(lua_State* L) {
    const ScenePart part = check_part(L, 1, tool_class);
    const auto index = static_cast<std::size_t>(part.handle.index);
    return {part.scene, part.handle.index, part.scene.model().tools[index], part.scene.tools()[index]};
}

int name(lua_State* L) {
    push(L, std::string_view(check_tool(L).model.name));
    return 1;
}

int move(lua_State* L) {
    const ToolPart tool = check_tool(L);
    DeviceSample order = tool.scene.order(tool.index);
    Options options(L, 2, "move");
    read_pose(L, options, order.pose);
    order.pedal = options.number("pedal", order.pedal, {0.0, 3.0});
    order.jaw = options.number("jaw", order.jaw, {0.0, 1.0});
    options.finish();
    order.present = true;
    tool.scene.order(tool.index) = order;
    return 0;
}

int move_to(lua_State* L) {
    const Vec3 place = check_vec3(L, 2);
    const ToolPart tool = check_tool(L);
    DeviceSample& order = tool.scene.order(tool.index);
    order.pose.position = place;
    order.present = true;
    return 0;
}

int withdraw(lua_State* L) {
    const ToolPart tool = check_tool(L);
    tool.scene.order(tool.index).present = false;
    return 0;
}

int position(lua_State* L) {
    push(L, check_tool(L).state.pose.position);
    return 1;
}

int axis(lua_State* L) {
    push(L, tool_axis(check_tool(L).state.pose));
    return 1;
}

int present(lua_State* L) {
    push(L, check_tool(L).state.present);
    return 1;
}

int force(lua_State* L) {
    const ToolPart tool = check_tool(L);
    Vec3 sum = Vec3::Zero();
    for (const Contact& contact : tool.scene.contacts()) {
        if (contact.partner == ContactPartner::tool && contact.partner_index == tool.index) {
            sum -= contact.force;  // the contact's own force acts on the solid
        }
    }
    push(L, sum);
    return 1;
}

}  // namespace

void define_tool_class(lua_State* L) {
    define_class(L, tool_class,
                 {{"name", guarded<name>},
                  {"move", guarded<move>},
                  {"move_to", guarded<move_to>},
                  {"withdraw", guarded<withdraw>},
                  {"position", guarded<position>},
                  {"axis", guarded<axis>},
                  {"present", guarded<present>},
                  {"force", guarded<force>}},
                 {});
}

}  // namespace rhexis::lua
