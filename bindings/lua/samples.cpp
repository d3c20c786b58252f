// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/samples.hpp"

#include <string>

namespace rhexis::lua {
namespace {

/// Number i of the table on top of the stack.
double item(lua_State* L, lua_Integer i) {
    lua_rawgeti(L, -1, i);
    const double value = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return value;
}

}  // namespace

Vec3 place_from(lua_State* L) { return {item(L, 1), item(L, 2), item(L, 3)}; }
Quat orientation_from(lua_State* L) { return {item(L, 1), item(L, 2), item(L, 3), item(L, 4)}; }

namespace {

double number_field(lua_State* L, const char* name) {
    lua_getfield(L, -1, name);
    const double value = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return value;
}

/// The sample table on top of the stack.
DeviceSample sample_from(lua_State* L) {
    DeviceSample sample;
    sample.instrument = static_cast<int>(number_field(L, "instrument"));
    lua_getfield(L, -1, "present");
    sample.present = lua_toboolean(L, -1) != 0;
    lua_pop(L, 1);
    lua_getfield(L, -1, "position");
    sample.pose.position = place_from(L);
    lua_pop(L, 1);
    lua_getfield(L, -1, "orientation");
    sample.pose.orientation = orientation_from(L);
    lua_pop(L, 1);
    sample.jaw = number_field(L, "jaw");
    sample.pedal = number_field(L, "pedal");
    return sample;
}

std::string string_field(lua_State* L, const char* name) {
    lua_getfield(L, -1, name);
    std::string value = lua_isstring(L, -1) != 0 ? lua_tostring(L, -1) : "";
    lua_pop(L, 1);
    return value;
}

CommandKind kind_from(const std::string& name) {
    if (name == "set") {
        return CommandKind::set;
    }
    if (name == "picture") {
        return CommandKind::picture;
    }
    if (name == "request") {
        return CommandKind::request;
    }
    return name == "finish" ? CommandKind::finish : CommandKind::say;
}

/// The command table on top of the stack.
Command command_from(lua_State* L) {
    Command command;
    command.kind = kind_from(string_field(L, "kind"));
    command.name = string_field(L, "name");
    command.text = string_field(L, "text");
    lua_getfield(L, -1, "value");
    command.value = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return command;
}

}  // namespace

std::vector<DeviceSample> samples_from(lua_State* L) {
    std::vector<DeviceSample> samples;
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(L, -1, i);
        samples.push_back(sample_from(L));
        lua_pop(L, 1);
    }
    return samples;
}

std::vector<Command> commands_from(lua_State* L) {
    std::vector<Command> commands;
    const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
    for (lua_Integer i = 1; i <= count; ++i) {
        lua_rawgeti(L, -1, i);
        commands.push_back(command_from(L));
        lua_pop(L, 1);
    }
    return commands;
}

void fill_row(lua_State* L, const Observation& observation) {
    lua_Integer at = 0;
    for (const double value : observation.values) {
        lua_pushnumber(L, value);
        lua_rawseti(L, -2, ++at);
    }
}

}  // namespace rhexis::lua
