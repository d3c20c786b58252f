// SPDX-License-Identifier: GPL-3.0-or-later
// The exercise's own Lua state: the engine of scripts/ with one curriculum in it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/result.hpp"
#include "flow/command.hpp"
#include "flow/observation.hpp"
#include "flow/scene.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/lua_state.hpp"

namespace rhexis {

/// The place of an exercise in an operation: see PartPlace.
struct JoinedPart {
    CurriculumFiles operation;
    int index = 1;
    nlohmann::json before;
};

class ExerciseScript {
public:
    /// Runs the curriculum and applies `set`. root: folder that holds scripts/ and assets/. chosen: how finely the
    /// scene is simulated, as ExerciseOptions have it.
    static Result<ExerciseScript> load(const CurriculumFiles& files, const std::string& root, std::uint64_t seed,
                                       const std::map<std::string, std::string>& set,
                                       const std::optional<JoinedPart>& joined,
                                       const std::optional<CurriculumFiles>& rubric,
                                       const std::optional<SceneAccuracy>& chosen);
    /// What can be read of an exercise with mistakes: its scene() is as far as it goes, and only "vocabulary_of" and
    /// "mistakes_of" may be asked.
    static Result<ExerciseScript> load_in_spite(const CurriculumFiles& files, const std::string& root);
    /// Whether a script gives a rubric, which an exercise can be judged by in place of its own.
    static bool is_rubric(const CurriculumFiles& files, const std::string& root);
    /// What an operation is made of: "title", "version", "summary", "objectives", and "parts", each with "id", "title",
    /// "exercise", "start", "continues", "opening", "where". Null when the curriculum is an exercise.
    static Result<nlohmann::json> listing(const CurriculumFiles& files, const std::string& root,
                                          const std::string& language = "");

    [[nodiscard]] const SceneDescription& scene() const { return scene_; }
    [[nodiscard]] const std::string& title() const { return title_; }
    [[nodiscard]] const std::vector<std::string>& objectives() const { return objectives_; }
    [[nodiscard]] const std::vector<std::string>& levels() const { return levels_; }
    [[nodiscard]] const nlohmann::json& version() const { return version_; }
    [[nodiscard]] double time_limit_s() const { return time_limit_s_; }
    [[nodiscard]] const nlohmann::json& goals() const { return goals_; }
    /// File beside the curriculum, without .lua, that says what a virtual surgeon does.
    [[nodiscard]] const std::string& plan() const { return plan_; }

    Status start(const ObservationSchema& schema);
    /// given: commands of the step that led there; requests and aids among them are heard.
    Result<std::vector<Command>> observe(const Observation& observation, std::span<const Command> given);
    [[nodiscard]] bool finished() const { return finished_; }
    /// Calls a function of scripts/engine/host.lua: "result", "events", "declared_events", "declared_requests",
    /// "watch", "reached", "review", "vocabulary", "vocabulary_of", "mistakes_of", "choose".
    Result<nlohmann::json> ask(const char* function, const nlohmann::json& argument = nullptr);

private:
    explicit ExerciseScript(LuaState state) : state_(std::move(state)) {}
    static Result<ExerciseScript> open(const CurriculumFiles& files, const std::string& root, std::uint64_t seed);
    Status open_engine();
    /// Files of texts beside the curriculum, and of marks.
    Status read_what_is_shown(const CurriculumFiles& files);
    /// Hands what the curriculum returns to a function of the engine, and its answer back.
    Result<nlohmann::json> run_curriculum(const CurriculumFiles& files, const char* receiver);
    Status join(const JoinedPart& joined);
    Status apply(const std::map<std::string, std::string>& set);
    Status read_scene(const std::string& root, const std::optional<SceneAccuracy>& chosen);
    void push_function(lua_State* L, const char* name) const;

    LuaState state_;
    LuaRef host_;  ///< the module scripts/engine/host.lua
    LuaRef observe_;
    LuaRef row_;
    SceneDescription scene_;
    std::string title_;
    std::vector<std::string> objectives_;
    std::vector<std::string> levels_;
    std::string plan_;
    nlohmann::json version_;
    nlohmann::json goals_;
    double time_limit_s_ = 0.0;
    bool finished_ = false;
};

}  // namespace rhexis
