// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/surgeon_script.hpp"

#include <cstdio>
#include <filesystem>

#include "base/rng.hpp"
#include "lua/json.hpp"
#include "lua/samples.hpp"
#include "lua/stack.hpp"

namespace rhexis {
namespace {

/// What print() of a plan shows. Not on standard output: that belongs to results and reports.
void print_surgeon_line(std::string_view line) {
    std::fprintf(stderr, "%.*s\n", static_cast<int>(line.size()), line.data());
}

void push_quaternion(lua_State* L, const Quat& q) {
    lua_createtable(L, 4, 0);
    const double values[] = {q.w(), q.x(), q.y(), q.z()};
    for (int i = 0; i < 4; ++i) {
        lua_pushnumber(L, values[i]);
        lua_rawseti(L, -2, i + 1);
    }
}

void push_tools(lua_State* L, const std::vector<PerceivedTool>& tools) {
    lua_createtable(L, 0, static_cast<int>(tools.size()));
    for (const PerceivedTool& tool : tools) {
        lua_createtable(L, 0, 3);
        lua::set_field(L, "present", tool.present);
        lua::set_field(L, "position", tool.pose.position);
        push_quaternion(L, tool.pose.orientation);
        lua_setfield(L, -2, "orientation");
        lua_setfield(L, -2, tool.name.c_str());
    }
}

void push_landmarks(lua_State* L, const std::vector<Landmark>& landmarks) {
    lua_createtable(L, 0, static_cast<int>(landmarks.size()));
    for (const Landmark& mark : landmarks) {
        if (!mark.visible) {
            continue;
        }
        lua_createtable(L, 0, 2);
        lua::set_field(L, "position", mark.position);
        lua::set_field(L, "size", mark.size);
        lua_setfield(L, -2, mark.name.c_str());
    }
}

void push_field(lua_State* L, const PerceivedField& field) {
    lua_createtable(L, 0, 3);
    lua::set_field(L, "position", field.position);
    lua::set_field(L, "radius", field.radius);
    lua::set_field(L, "out_of_focus_mm", field.out_of_focus);
}

void push_percept(lua_State* L, const Percept& percept) {
    lua_createtable(L, 0, 10);
    lua::set_field(L, "time_s", percept.time_s);
    lua::set_field(L, "tip_brightness", percept.tip_brightness);
    lua::set_field(L, "reflex_brightness", percept.reflex_brightness);
    lua::set_field(L, "pedal", percept.pedal);
    lua::set_field(L, "power", percept.power);
    lua::set_field(L, "vacuum_mmhg", percept.vacuum_mmhg);
    lua::set_field(L, "flow_ml_min", percept.flow_ml_min);
    push_tools(L, percept.tools);
    lua_setfield(L, -2, "tools");
    push_landmarks(L, percept.landmarks);
    lua_setfield(L, -2, "landmarks");
    if (percept.field) {
        push_field(L, *percept.field);
        lua_setfield(L, -2, "field");
    }
}

/// A stream apart from the exercise's own.
std::uint64_t surgeon_seed(std::uint64_t seed) {
    Rng rng(seed, "surgeon");
    const std::uint64_t high = rng.next();
    return (high << 32) | rng.next();
}

}  // namespace

Result<SurgeonScript> SurgeonScript::load(const std::string& name, const CurriculumFiles& files,
                                          const std::string& plan, const std::map<std::string, std::string>& habits,
                                          const std::string& root, std::uint64_t seed) {
    LuaOptions options;
    options.seed = surgeon_seed(seed);
    options.print = print_surgeon_line;
    options.folders = {{root + "/scripts", "scripts"}, {files.folder, files.id}};
    Result<LuaState> state = LuaState::create(std::move(options));
    if (!state) {
        return state.error();
    }
    SurgeonScript script(std::move(state).value());
    std::string complaint;
    const Status status = script.state_.run([&](lua_State* L) {
        lua_getglobal(L, "require");
        lua_pushstring(L, "surgeons.surgeon");
        lua_call(L, 1, 1);
        lua_pushvalue(L, -1);
        script.host_ = LuaRef(script.state_, L);
        lua_getfield(L, -1, "choose");
        lua::push(L, std::string_view(name));
        lua::push(L, std::string_view(plan));
        lua_createtable(L, 0, static_cast<int>(habits.size()));
        for (const auto& [habit, value] : habits) {
            lua::set_field(L, habit.c_str(), std::string_view(value));
        }
        lua_call(L, 3, 1);
        if (lua_isstring(L, -1) != 0) {
            complaint = lua_tostring(L, -1);
        }
    });
    if (!status) {
        return status.error();
    }
    if (!complaint.empty()) {
        return Error{complaint, "surgeon", ""};
    }
    return script;
}

Status SurgeonScript::start(const std::vector<std::string>& instruments, double step_s,
                            const nlohmann::json& requests) {
    return state_.run([&](lua_State* L) {
        host_.push(L);
        lua_getfield(L, -1, "start");
        lua::push(L, instruments);
        lua_pushnumber(L, step_s);
        lua::push_json(L, requests);
        lua_call(L, 3, 0);
        lua_getfield(L, -1, "operate");
        operate_ = LuaRef(state_, L);
    });
}

Result<OperatorStep> SurgeonScript::operate(const Percept& percept) {
    OperatorStep step;
    const Status status = state_.run([&](lua_State* L) {
        operate_.push(L);
        push_percept(L, percept);
        lua_call(L, 1, 2);
        step.commands = lua::commands_from(L);
        lua_pop(L, 1);
        step.samples = lua::samples_from(L);
    });
    if (!status) {
        return status.error();
    }
    return step;
}

}  // namespace rhexis
