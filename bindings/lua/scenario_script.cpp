// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/scenario_script.hpp"

#include <cstdio>
#include <filesystem>

#include "lua/curriculum_files.hpp"
#include "lua/json.hpp"
#include "lua/samples.hpp"
#include "lua/stack.hpp"

namespace rhexis {
namespace {

/// "groove/tests/iris.lua": the last names of a path, as many as Lua shows whole in its messages.
std::string short_name(const std::string& path) {
    const std::filesystem::path whole = std::filesystem::weakly_canonical(path);
    std::string name = whole.filename().string();
    std::filesystem::path folder = whole.parent_path();
    for (int level = 0; level < 2 && folder.has_filename(); ++level, folder = folder.parent_path()) {
        const std::string longer = folder.filename().string() + "/" + name;
        if (longer.size() > 55) {
            break;
        }
        name = longer;
    }
    return name;
}

/// What print() of a scenario shows. Not on standard output: that belongs to the results, and to reports.
void print_line(std::string_view line) { std::fprintf(stderr, "%.*s\n", static_cast<int>(line.size()), line.data()); }

}  // namespace

void ScenarioScript::push_function(lua_State* L, const char* name) const {
    host_.push(L);
    lua_getfield(L, -1, name);
    lua_remove(L, -2);
}

Result<ScenarioScript> ScenarioScript::load(const std::string& path, const std::string& kind, const std::string& root) {
    const Result<std::string> text = read_script(path);
    if (!text) {
        return text.error();
    }
    LuaOptions options;
    options.print = print_line;
    options.folders = {{root + "/scripts", "scripts"},
                       {std::filesystem::path(path).parent_path().string(), "beside the file"}};
    Result<LuaState> state = LuaState::create(std::move(options));
    if (!state) {
        return state.error();
    }
    ScenarioScript script(std::move(state).value());
    script.chunk_ = short_name(path);
    const Status status = script.state_.run([&](lua_State* L) {
        lua_getglobal(L, "require");
        lua_pushstring(L, "scenario.host");
        lua_call(L, 1, 1);
        script.host_ = LuaRef(script.state_, L);
        script.push_function(L, "begin_file");
        lua::push(L, std::string_view(script.chunk_));
        lua::push(L, std::string_view(text.value()));
        lua_call(L, 2, 0);
        script.push_function(L, "read");
        lua::push(L, std::string_view(kind));
        lua::load_text(L, text.value(), script.chunk_);
        script.push_function(L, "environment");
        lua_call(L, 0, 1);
        lua_setupvalue(L, -2, 1);  // the file's globals
        lua_call(L, 2, 0);
        script.push_function(L, "listing");
        lua_call(L, 0, 1);
        script.listing_ = lua::to_json(L, -1);
    });
    if (!status) {
        return status.error();
    }
    return script;
}

Status ScenarioScript::start(const nlohmann::json& setup) {
    return state_.run([&](lua_State* L) {
        push_function(L, "start");
        lua::push_json(L, setup);
        lua_call(L, 1, 1);
        row_ = LuaRef(state_, L);
    });
}

Result<OperatorStep> ScenarioScript::step(const Observation& observation, const nlohmann::json& events) {
    OperatorStep step;
    const Status status = state_.run([&](lua_State* L) {
        row_.push(L);
        lua::fill_row(L, observation);
        lua_pop(L, 1);
        push_function(L, "step");
        lua_pushnumber(L, observation.time_s);
        lua::push_json(L, events);
        lua_call(L, 2, 1);
        lua_getfield(L, -1, "done");
        step.done = lua_toboolean(L, -1) != 0;
        lua_pop(L, 1);
        if (!step.done) {
            lua_getfield(L, -1, "samples");
            step.samples = lua::samples_from(L);
            lua_pop(L, 1);
            lua_getfield(L, -1, "commands");
            step.commands = lua::commands_from(L);
        }
    });
    if (!status) {
        return status.error();
    }
    return step;
}

Status ScenarioScript::refused(const std::string& why) {
    return state_.run([&](lua_State* L) {
        push_function(L, "refused");
        lua::push(L, std::string_view(why));
        lua_call(L, 1, 0);
    });
}

Status ScenarioScript::judged(const nlohmann::json& result) {
    return state_.run([&](lua_State* L) {
        push_function(L, "judged");
        lua::push_json(L, result);
        lua_call(L, 1, 0);
    });
}

Result<nlohmann::json> ScenarioScript::outcome() {
    nlohmann::json value;
    const Status status = state_.run([&](lua_State* L) {
        push_function(L, "outcome");
        lua_call(L, 0, 1);
        value = lua::to_json(L, -1);
    });
    if (!status) {
        return status.error();
    }
    return value;
}

}  // namespace rhexis
