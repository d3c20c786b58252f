// SPDX-License-Identifier: GPL-3.0-or-later
// Runs an exercise script beside a session: the exercise engine in one sandboxed Lua state, the virtual surgeon in
// another. Knows nothing of files but the scripts themselves.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/command.hpp"
#include "flow/observation.hpp"
#include "flow/percept.hpp"
#include "flow/scene.hpp"
#include "session/trial.hpp"

namespace rhexis {

/// An exercise as a part of an operation.
struct PartPlace {
    std::string operation;                             ///< as for rhexis run
    int index = 1;                                     ///< of the part in it, from 1
    nlohmann::json before = nlohmann::json::object();  ///< what the part before it left: "carried" of its result
};

struct ExerciseOptions {
    std::string curriculum;        ///< folder, file, or bare name of a folder in curricula/
    std::string surgeon = "none";  ///< "none", or a group of scripts/surgeons: "expert", "novice", a..d; or "random"
    std::uint64_t seed = 1;
    std::map<std::string, std::string> set;   ///< --set key=value: patient fields, settings of the
                                              ///< exercise, habits of the virtual surgeon (surgeon.recovery)
    std::string root;                         ///< folder that holds scripts/ and curricula/
    std::optional<PartPlace> part{};          ///< none: the exercise stands alone
    std::string rubric{};                     ///< file to judge by in place of the exercise's own; empty: none
    std::optional<SceneAccuracy> accuracy{};  ///< how finely it is simulated, as was chosen before: of a recording that
                                              ///< is judged again; none: the tables say
};

/// The file of a rubric, which is named by its path, or by its path or bare name in root/rubrics; "" when the name is
/// none.
std::string find_rubric(const std::string& name, const std::string& root);

class ExerciseHost final : public Exercise {
public:
    /// Loads and checks the script; errors name file:line, and near names for an unknown curriculum or surgeon.
    static Result<ExerciseHost> load(const ExerciseOptions& options);
    ~ExerciseHost() override;
    ExerciseHost(ExerciseHost&&) noexcept;

    [[nodiscard]] const SceneDescription& scene() const;
    [[nodiscard]] const nlohmann::json& identity() const;  ///< {"id","title","version","sha256","time_limit_s"}

    /// What the trainee is to learn, in the language of the run.
    [[nodiscard]] const std::vector<std::string>& objectives() const;

    /// Names of its levels of difficulty, sorted.
    [[nodiscard]] const std::vector<std::string>& levels() const;
    /// What rhexis check tells of an exercise that runs: "faults", "notes", "untranslated", lists of lines. After
    /// start.
    [[nodiscard]] Result<nlohmann::json> review();
    /// Names of the measures that its steps, events and scores use. After start.
    [[nodiscard]] Result<std::vector<std::string>> used_measures();
    /// Every name that the exercise may use: list of {"title", "lines": [{"name", "text"}]}. After start.
    [[nodiscard]] Result<nlohmann::json> vocabulary();

    /// The vocabulary of an exercise that cannot be started; without measures, where its scene cannot be built.
    static Result<nlohmann::json> vocabulary_in_spite(const ExerciseOptions& options);
    /// What is wrong with the conditions of an exercise that cannot be loaded: list of lines.
    static Result<nlohmann::json> mistakes_in_spite(const ExerciseOptions& options);

    /// Once, before the first step.
    Status start(const ObservationSchema& schema, const std::vector<std::string>& instruments) override;

    /// Stage 6: the curriculum sees the observation, and hears the requests among the commands of the step that led to
    /// it; what it wants comes back as commands. A script error (file, line, step) ends the exercise, not the session.
    Result<std::vector<Command>> observe(const Observation& observation, std::span<const Command> given = {}) override;

    /// The virtual surgeon sees the percept, with this person's delay and noise, and moves the instruments
    /// and asks the staff.
    Result<OperatorStep> operate(const Percept& percept);

    [[nodiscard]] bool finished() const override;
    [[nodiscard]] bool has_surgeon() const;

    /// Named numbers of the exercise, after --set.
    [[nodiscard]] const nlohmann::json& goals() const;
    /// The error events that the exercise declares: [{"id", "title"}].
    [[nodiscard]] Result<nlohmann::json> declared_events();
    /// What may be asked of the staff: [{"id", "title", "name"}].
    [[nodiscard]] Result<nlohmann::json> declared_requests();
    /// The error events that were raised so far: [{"id", "title", "time_s", "outcome", "recovery_s"}].
    [[nodiscard]] Result<nlohmann::json> events();

    /// Where the tip is to be in the step that runs, in the eye's frame [mm]: one place, or a way through several.
    /// Empty where the exercise marks none, and in an exam. After start.
    [[nodiscard]] Result<std::vector<Vec3>> marks();
    /// What the theatre's monitor shows now: "steps", "events", "warnings", "vitals", "notes", and if wanted the
    /// "score" as it would be if the attempt ended here.
    [[nodiscard]] Result<nlohmann::json> theatre(bool score);
    /// Warnings that show now: list of {"title", "advice"}.
    [[nodiscard]] Result<nlohmann::json> warnings();
    /// What an instructor may let happen in this scene; see scripts/theatre/injections.lua. After start.
    [[nodiscard]] Result<nlohmann::json> injections();
    /// The settings of one of its levels that may change while it runs, and how many others it has:
    /// {"settings": {name: value}, "later": number}.
    [[nodiscard]] Result<nlohmann::json> level_now(const std::string& level);

    /// Whether the turn has just come to another step of the exercise.
    Result<bool> at_boundary();
    /// Reads the exercise again if its files have changed, and goes on with it where it was: steps, events and scores
    /// of the same names keep what is known of them. Gives the commands that its changed settings need; nothing when no
    /// file has changed. Refused, and the exercise stays as it was, where it has mistakes or wants another scene.
    Result<std::optional<std::vector<Command>>> reload();

    /// Watches for a moment of the run: a condition, as the exercise may write it. After start; where: for messages.
    Status watch(const std::string& when, const std::string& where);
    /// Whether that moment is now.
    Result<bool> reached();

    /// "completed", "steps", "events", "osacss", "measures", "advice" of report.json, as far as the exercise has come.
    /// Of a part, the same of the operation in "operation", with what the next part begins with in "carried".
    [[nodiscard]] Result<nlohmann::json> result();

private:
    struct Parts;
    explicit ExerciseHost(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis
