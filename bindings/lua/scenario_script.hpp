// SPDX-License-Identifier: GPL-3.0-or-later
// A file of scenario tests, or of the states that an exercise prepares, in a sandboxed Lua state of its own.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/result.hpp"
#include "lua/lua_state.hpp"
#include "session/trial.hpp"

namespace rhexis {

class ScenarioScript {
public:
    /// Runs the file. kind: "scenarios" or "starts", which it must return. root: folder that holds scripts/.
    static Result<ScenarioScript> load(const std::string& path, const std::string& kind, const std::string& root);

    /// What the file declares: {"exercise", "list": [{"name","line","seed","set","start","silent_twin_of"}]} of
    /// scenarios, a map of {"surgeon","seed","set","when","limit_s","where","by_hand"} of starts.
    [[nodiscard]] const nlohmann::json& listing() const { return listing_; }
    /// The name that stands for the file in messages.
    [[nodiscard]] const std::string& chunk() const { return chunk_; }

    /// Begins a scenario or a start that is made by hand. setup: {"number" (from 1) or "start" (name), "schema",
    /// "goals", "events", "requests", "settings", "instruments", "landmarks", "step_s"}, as
    /// scripts/scenario/test.lua reads them.
    Status start(const nlohmann::json& setup);
    /// events: as ExerciseHost::events gives them. Its commands are settings and requests.
    Result<OperatorStep> step(const Observation& observation, const nlohmann::json& events);
    /// The kernel did not take what the last step asked for: the scenario fails on the line that runs.
    Status refused(const std::string& why);
    /// result: of the exercise at the end, as ExerciseHost::result gives it. An item with more points than its errors
    /// leave it fails the scenario.
    Status judged(const nlohmann::json& result);
    /// {"at": file:line where it waits, "failures": [{"where","message","time_s"}], "covered": {event:
    /// {"raised","recovered","not_recovered","silent"}}}
    Result<nlohmann::json> outcome();

private:
    explicit ScenarioScript(LuaState state) : state_(std::move(state)) {}
    void push_function(lua_State* L, const char* name) const;

    LuaState state_;
    LuaRef host_;  ///< the module scripts/scenario/host.lua
    LuaRef row_;
    nlohmann::json listing_;
    std::string chunk_;
};

}  // namespace rhexis
