// SPDX-License-Identifier: GPL-3.0-or-later
// A virtual surgeon in a Lua state of its own. It is given a percept and nothing else: no observation, event or score.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/percept.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/lua_state.hpp"
#include "session/trial.hpp"

namespace rhexis {

class SurgeonScript {
public:
    /// name: of a group or an alias in scripts/surgeons/groups.lua. plan: file of the curriculum's folder, without
    /// .lua. habits: what --set surgeon.* asked for, by name. Fails with near names for an unknown surgeon or habit.
    static Result<SurgeonScript> load(const std::string& name, const CurriculumFiles& files, const std::string& plan,
                                      const std::map<std::string, std::string>& habits, const std::string& root,
                                      std::uint64_t seed);

    /// requests: what may be asked of the staff, [{"id", "title", "name"}].
    Status start(const std::vector<std::string>& instruments, double step_s, const nlohmann::json& requests);
    Result<OperatorStep> operate(const Percept& percept);

private:
    explicit SurgeonScript(LuaState state) : state_(std::move(state)) {}

    LuaState state_;
    LuaRef host_;  ///< the module scripts/surgeons/surgeon.lua
    LuaRef operate_;
};

}  // namespace rhexis
