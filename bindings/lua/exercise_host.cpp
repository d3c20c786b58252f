// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/exercise_host.hpp"

#include <filesystem>

#include <optional>

#include "lua/cohorts.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/exercise_script.hpp"
#include "lua/surgeon_script.hpp"
#include "session/session.hpp"
#include "session/settings.hpp"

namespace rhexis {

using nlohmann::json;

struct ExerciseHost::Parts {
    ExerciseOptions options;
    ObservationSchema schema;
    ExerciseScript exercise;
    std::optional<SurgeonScript> surgeon;
    json identity;
};

namespace {

constexpr std::string_view surgeon_prefix = "surgeon.";

/// What is set of the surgeon, without the prefix; the rest stays.
std::map<std::string, std::string> take_habits(std::map<std::string, std::string>& set) {
    std::map<std::string, std::string> habits;
    std::erase_if(set, [&](const auto& entry) {
        if (!entry.first.starts_with(surgeon_prefix)) {
            return false;
        }
        habits[entry.first.substr(surgeon_prefix.size())] = entry.second;
        return true;
    });
    return habits;
}

}  // namespace

std::string find_rubric(const std::string& name, const std::string& root) {
    for (const std::string& path : {name, root + "/" + name, root + "/rubrics/" + name + ".lua"}) {
        std::error_code failed;
        if (!path.ends_with(".lua") || !std::filesystem::is_regular_file(path, failed)) {
            continue;
        }
        const Result<CurriculumFiles> files = find_curriculum(path, root);
        if (files && ExerciseScript::is_rubric(files.value(), root)) {
            return path;
        }
    }
    return "";
}

Result<ExerciseHost> ExerciseHost::load(const ExerciseOptions& options) {
    const Result<CurriculumFiles> files = find_curriculum(options.curriculum, options.root);
    if (!files) {
        return files.error();
    }
    std::map<std::string, std::string> set = options.set;
    const std::map<std::string, std::string> habits = take_habits(set);
    if (options.surgeon == "none" && !habits.empty()) {
        return Error{"--set surgeon." + habits.begin()->first + ": nobody operates", "",
                     "a virtual surgeon, as in --surgeon a"};
    }
    std::optional<JoinedPart> joined;
    if (options.part) {
        const Result<CurriculumFiles> operation = find_curriculum(options.part->operation, options.root);
        if (!operation) {
            return operation.error();
        }
        joined = JoinedPart{operation.value(), options.part->index, options.part->before};
    }
    std::optional<CurriculumFiles> rubric;
    if (!options.rubric.empty()) {
        const Result<CurriculumFiles> found = find_curriculum(options.rubric, options.root);
        if (!found) {
            return found.error();
        }
        rubric = found.value();
    }
    Result<ExerciseScript> exercise =
        ExerciseScript::load(files.value(), options.root, options.seed, set, joined, rubric, options.accuracy);
    if (!exercise) {
        return exercise.error();
    }
    const Result<json> cohort = reference_cohort(files.value(), options.root);
    const Result<json> taken = cohort ? exercise.value().ask("take_cohort", cohort.value()) : cohort;
    if (!taken) {
        return taken.error();
    }
    std::optional<SurgeonScript> surgeon;
    if (options.surgeon != "none") {
        Result<SurgeonScript> loaded = SurgeonScript::load(options.surgeon, files.value(), exercise.value().plan(),
                                                           habits, options.root, options.seed);
        if (!loaded) {
            return loaded.error();
        }
        surgeon.emplace(std::move(loaded).value());
    }
    const json identity = {{"id", files.value().id},
                           {"title", exercise.value().title()},
                           {"version", exercise.value().version()},
                           {"sha256", files.value().sha256},
                           {"time_limit_s", exercise.value().time_limit_s()}};
    return ExerciseHost(
        std::make_unique<Parts>(Parts{options, {}, std::move(exercise).value(), std::move(surgeon), identity}));
}

ExerciseHost::ExerciseHost(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ExerciseHost::~ExerciseHost() = default;
ExerciseHost::ExerciseHost(ExerciseHost&&) noexcept = default;

const SceneDescription& ExerciseHost::scene() const { return parts_->exercise.scene(); }
const json& ExerciseHost::identity() const { return parts_->identity; }
const std::vector<std::string>& ExerciseHost::objectives() const { return parts_->exercise.objectives(); }
const std::vector<std::string>& ExerciseHost::levels() const { return parts_->exercise.levels(); }
Result<json> ExerciseHost::review() { return parts_->exercise.ask("review"); }
Result<std::vector<std::string>> ExerciseHost::used_measures() {
    const Result<json> used = parts_->exercise.ask("used_measures");
    return used ? Result<std::vector<std::string>>(used.value().get<std::vector<std::string>>()) : used.error();
}
Result<json> ExerciseHost::vocabulary() { return parts_->exercise.ask("vocabulary"); }

namespace {

/// Asks what can be told of an exercise that cannot be started.
Result<json> ask_in_spite(const char* function, const ExerciseOptions& options) {
    const Result<CurriculumFiles> files = find_curriculum(options.curriculum, options.root);
    if (!files) {
        return files.error();
    }
    Result<ExerciseScript> script = ExerciseScript::load_in_spite(files.value(), options.root);
    if (!script) {
        return script.error();
    }
    json measures = json::array();
    const Result<Session> session = Session::create(script.value().scene(), 1);
    for (const MeasureInfo& info : session ? session.value().schema() : ObservationSchema()) {
        measures.push_back({{"name", info.name}, {"unit", info.unit}, {"meaning", info.meaning}});
    }
    return script.value().ask(function, measures);
}

}  // namespace

Result<json> ExerciseHost::vocabulary_in_spite(const ExerciseOptions& options) {
    return ask_in_spite("vocabulary_of", options);
}
Result<json> ExerciseHost::mistakes_in_spite(const ExerciseOptions& options) {
    return ask_in_spite("mistakes_of", options);
}

Status ExerciseHost::start(const ObservationSchema& schema, const std::vector<std::string>& instruments) {
    parts_->schema = schema;
    Status status = parts_->exercise.start(schema);
    if (!status || !parts_->surgeon) {
        return status;
    }
    const Result<json> requests = declared_requests();
    return requests ? parts_->surgeon->start(instruments, scene().step_s, requests.value()) : requests.error();
}

Result<std::vector<Command>> ExerciseHost::observe(const Observation& observation, std::span<const Command> given) {
    return parts_->exercise.observe(observation, given);
}

Result<OperatorStep> ExerciseHost::operate(const Percept& percept) {
    if (!parts_->surgeon) {
        return OperatorStep{};
    }
    return parts_->surgeon->operate(percept);
}

bool ExerciseHost::finished() const { return parts_->exercise.finished(); }
bool ExerciseHost::has_surgeon() const { return parts_->surgeon.has_value(); }
const json& ExerciseHost::goals() const { return parts_->exercise.goals(); }
Result<json> ExerciseHost::declared_events() { return parts_->exercise.ask("declared_events"); }
Result<json> ExerciseHost::declared_requests() { return parts_->exercise.ask("declared_requests"); }
Result<json> ExerciseHost::events() { return parts_->exercise.ask("events"); }
Result<json> ExerciseHost::result() { return parts_->exercise.ask("result"); }

Result<json> ExerciseHost::theatre(bool score) { return parts_->exercise.ask("theatre", score); }
Result<json> ExerciseHost::warnings() { return parts_->exercise.ask("warnings"); }
Result<json> ExerciseHost::injections() { return parts_->exercise.ask("injections"); }
Result<json> ExerciseHost::level_now(const std::string& level) { return parts_->exercise.ask("level_now", level); }

Result<std::vector<Vec3>> ExerciseHost::marks() {
    const Result<json> given = parts_->exercise.ask("marks");
    if (!given) {
        return given.error();
    }
    std::vector<Vec3> places;
    for (const json& place : given.value()) {
        places.emplace_back(place[0].get<double>(), place[1].get<double>(), place[2].get<double>());
    }
    return places;
}

Result<bool> ExerciseHost::at_boundary() {
    const Result<json> now = parts_->exercise.ask("at_boundary");
    return now ? Result<bool>(now.value() == true) : now.error();
}

namespace {

/// What of a scene is built before the first step.
json built(const SceneDescription& scene) {
    json settings = json::object();
    for (const auto& [name, value] : scene.settings) {
        const SettingInfo* info = find_setting(name);
        if (info != nullptr && (!info->live || info->tissue)) {
            settings[name] = value;
        }
    }
    const Patient& patient = scene.patient;
    return {scene.tissues,    scene.instruments,     scene.step_s, static_cast<int>(scene.advance),
            patient.age,      patient.nuclear_grade, patient.side, patient.cortical_opacity,
            patient.pupil_mm, patient.tetrahedra,    settings};
}

/// The settings that a changed exercise wants otherwise.
std::vector<Command> changes(const SceneDescription& before, const SceneDescription& after) {
    std::vector<Command> commands;
    for (const SettingInfo& info : setting_table()) {
        const auto of = [&info](const SceneDescription& scene) {
            const auto found = scene.settings.find(std::string(info.name));
            return found == scene.settings.end() ? info.standard : found->second;
        };
        if (info.live && !info.tissue && of(before) != of(after)) {
            commands.push_back({CommandKind::set, std::string(info.name), of(after), ""});
        }
    }
    return commands;
}

}  // namespace

Result<std::optional<std::vector<Command>>> ExerciseHost::reload() {
    const Result<CurriculumFiles> files = find_curriculum(parts_->options.curriculum, parts_->options.root);
    if (!files) {
        return files.error();
    }
    if (files.value().sha256 == parts_->identity.at("sha256")) {
        return std::optional<std::vector<Command>>();
    }
    parts_->identity["sha256"] = files.value().sha256;  // a mistake is told once, until the file changes again
    ExerciseOptions options = parts_->options;
    options.surgeon = "none";
    std::erase_if(options.set, [](const auto& entry) { return entry.first.starts_with(surgeon_prefix); });
    Result<ExerciseHost> changed = load(options);
    if (!changed) {
        return changed.error();
    }
    if (built(changed.value().scene()) != built(scene())) {
        return Error{"the changed exercise wants another patient, tissues, instruments or fixed settings", "",
                     "a new run"};
    }
    const Result<json> left = parts_->exercise.ask("left");
    Status going = left ? changed.value().start(parts_->schema, {}) : Status(left.error());
    ExerciseScript& next = changed.value().parts_->exercise;
    if (going) {
        const Result<json> taken = next.ask("take_up", left.value());
        going = taken ? success() : Status(taken.error());
    }
    if (!going) {
        return going.error();
    }
    std::vector<Command> commands = changes(scene(), next.scene());
    Parts& fresh = *changed.value().parts_;
    fresh.options = parts_->options;
    if (parts_->surgeon) {
        fresh.surgeon.emplace(std::move(*parts_->surgeon));  // whoever operates goes on with the plan that was begun
        parts_->surgeon.reset();
    }
    parts_ = std::move(changed.value().parts_);
    return std::optional<std::vector<Command>>(std::move(commands));
}

Status ExerciseHost::watch(const std::string& when, const std::string& where) {
    const Result<json> watching = parts_->exercise.ask("watch", {{"when", when}, {"where", where}});
    return watching ? success() : Status(watching.error());
}

Result<bool> ExerciseHost::reached() {
    const Result<json> now = parts_->exercise.ask("reached");
    if (!now) {
        return now.error();
    }
    return now.value() == true;
}

}  // namespace rhexis
