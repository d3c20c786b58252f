// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/exercise_script.hpp"

#include <algorithm>
#include <filesystem>

#include "lua/accuracy_words.hpp"
#include "lua/json.hpp"
#include "lua/samples.hpp"
#include "lua/stack.hpp"
#include "session/choose_accuracy.hpp"
#include "session/settings.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

std::vector<std::string> setting_names() {
    std::vector<std::string> names;
    for (const SettingInfo& info : setting_table()) {
        names.emplace_back(info.name);
    }
    return names;
}

std::vector<std::string> live_settings() {
    std::vector<std::string> names;
    for (const SettingInfo& info : setting_table()) {
        if (info.live) {
            names.emplace_back(info.name);
        }
    }
    return names;
}

Patient patient_from(const json& given) {
    Patient patient;
    patient.age = given.value("age", patient.age);
    patient.nuclear_grade = given.value("nuclear_grade", patient.nuclear_grade);
    patient.cortical_opacity = given.value("cortical_opacity", patient.cortical_opacity);
    patient.pupil_mm = given.value("pupil_mm", patient.pupil_mm);
    patient.side = given.value("side", patient.side);
    patient.tetrahedra = given.value("tetrahedra", patient.tetrahedra);
    return patient;
}

/// What the engine checks the settings of a curriculum against.
json settings_known() {
    json list = json::array();
    for (const SettingInfo& info : setting_table()) {
        if (info.name.empty()) {
            continue;
        }
        list.push_back({{"name", info.name},
                        {"from", info.minimum},
                        {"to", info.maximum},
                        {"standard", info.standard},
                        {"unit", info.unit},
                        {"meaning", info.meaning},
                        {"live", info.live},
                        {"tissue", info.tissue}});
    }
    return list;
}

/// The names in `set` in the order in which they are applied: a level first, what is set besides changes it.
std::vector<std::string> in_order(const std::map<std::string, std::string>& set) {
    std::vector<std::string> names;
    for (const auto& [name, value] : set) {
        names.insert(name == "level" ? names.begin() : names.end(), name);
    }
    return names;
}

namespace fs = std::filesystem;

/// A file beside a curriculum.
CurriculumFiles beside(const CurriculumFiles& files, const std::string& name) {
    const fs::path script(files.script);
    CurriculumFiles other = files;
    other.script = (script.parent_path() / name).string();
    other.chunk = files.chunk.substr(0, files.chunk.size() - script.filename().string().size()) + name;
    return other;
}

/// Files of texts beside a curriculum, such as curriculum.fr.lua, sorted.
std::vector<CurriculumFiles> texts_beside(const CurriculumFiles& files) {
    const fs::path script(files.script);
    const std::string stem = script.stem().string() + ".";
    std::vector<CurriculumFiles> found;
    std::error_code failed;
    for (fs::directory_iterator at(script.parent_path(), failed), end; !failed && at != end; at.increment(failed)) {
        const std::string name = at->path().filename().string();
        if (name.starts_with(stem) && name.ends_with(".lua") && name.size() == stem.size() + 6) {
            found.push_back(beside(files, name));
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.script < b.script; });
    return found;
}

Advance advance_from(const std::string& name) {
    if (name == "explicit") {
        return Advance::explicit_;
    }
    return name == "implicit" ? Advance::implicit : Advance::automatic;
}

SceneDescription scene_from(const json& given) {
    SceneDescription scene;
    scene.patient = patient_from(given.at("patient"));
    scene.tissues = given.at("tissues").get<std::vector<std::string>>();
    scene.instruments = given.at("instruments").get<std::vector<std::string>>();
    scene.settings = given.at("settings").get<std::map<std::string, double>>();
    scene.step_s = given.at("step_s");
    scene.advance = advance_from(given.at("advance"));
    return scene;
}

void push_schema(lua_State* L, const ObservationSchema& schema) {
    lua_createtable(L, static_cast<int>(schema.size()), 0);
    lua_Integer at = 0;
    for (const MeasureInfo& info : schema) {
        lua_createtable(L, 0, 3);
        lua::set_field(L, "name", std::string_view(info.name));
        lua::set_field(L, "unit", std::string_view(info.unit));
        lua::set_field(L, "meaning", std::string_view(info.meaning));
        lua_rawseti(L, -2, ++at);
    }
}

/// The mistakes of two files.
Error both(Error first, const Error& second) {
    const std::vector<std::string> more = second.lines();
    first.more.insert(first.more.end(), more.begin(), more.end());
    return first;
}

}  // namespace

void ExerciseScript::push_function(lua_State* L, const char* name) const {
    host_.push(L);
    lua_getfield(L, -1, name);
    lua_remove(L, -2);
}

Status ExerciseScript::open_engine() {
    return state_.run([this](lua_State* L) {
        lua_getglobal(L, "require");
        lua_pushstring(L, "engine.host");
        lua_call(L, 1, 1);
        host_ = LuaRef(state_, L);
        push_function(L, "know_settings");
        lua::push_json(L, settings_known());
        lua_call(L, 1, 0);
        push_function(L, "know_quantities");
        lua::push_json(L, quantities_json());
        lua_call(L, 1, 0);
    });
}

Result<json> ExerciseScript::run_curriculum(const CurriculumFiles& files, const char* receiver) {
    Result<std::string> text = read_script(files.script);
    if (!text) {
        return text.error();
    }
    json answer;
    const Status status = state_.run([&](lua_State* L) {
        push_function(L, "begin_file");
        lua::push(L, std::string_view(files.chunk));
        lua::push(L, std::string_view(text.value()));
        lua_call(L, 2, 0);
        push_function(L, "read");
        lua::push(L, std::string_view(receiver));
        lua::load_text(L, text.value(), files.chunk);
        push_function(L, "environment");
        lua_call(L, 0, 1);
        lua_setupvalue(L, -2, 1);  // the curriculum's globals
        lua_call(L, 2, 1);
        answer = lua::to_json(L, -1);
    });
    return status ? Result<json>(std::move(answer)) : status.error();
}

Status ExerciseScript::read_what_is_shown(const CurriculumFiles& files) {
    for (const CurriculumFiles& texts : texts_beside(files)) {
        const Result<json> read = run_curriculum(texts, "accept_texts");
        if (!read) {
            return read.error();
        }
    }
    const CurriculumFiles marks = beside(files, fs::path(files.script).stem().string() + ".marks.lua");
    std::error_code failed;
    if (!fs::is_regular_file(marks.script, failed)) {
        return success();
    }
    const Result<json> read = run_curriculum(marks, "accept_marks");
    return read ? success() : Status(read.error());
}

Status ExerciseScript::join(const JoinedPart& joined) {
    const Result<json> made =
        ask("join", {{"index", joined.index}, {"before", joined.before}, {"live", live_settings()}});
    return made ? success() : Status(made.error());
}

Status ExerciseScript::apply(const std::map<std::string, std::string>& set) {
    std::string complaint;
    Status status = state_.run([&](lua_State* L) {
        for (const std::string& name : in_order(set)) {
            push_function(L, "set");
            lua::push(L, std::string_view(name));
            lua::push(L, std::string_view(set.at(name)));
            lua::push(L, setting_names());
            lua_call(L, 3, 1);
            if (lua_isstring(L, -1) != 0) {
                complaint = lua_tostring(L, -1);
                return;
            }
            lua_pop(L, 1);
        }
    });
    if (status && !complaint.empty()) {
        return Error{complaint, "", ""};
    }
    return status;
}

Status ExerciseScript::read_scene(const std::string& root, const std::optional<SceneAccuracy>& chosen) {
    json given;
    Status status = state_.run([&](lua_State* L) {
        push_function(L, "scene");
        lua_call(L, 0, 1);
        given = lua::to_json(L, -1);
    });
    if (!status) {
        return status;
    }
    scene_ = scene_from(given);
    title_ = given.at("title");
    levels_ = given.at("levels").get<std::vector<std::string>>();
    objectives_ = given.at("objectives").get<std::vector<std::string>>();
    version_ = given.at("version");
    plan_ = given.at("surgeon");
    time_limit_s_ = given.at("time_limit_s");
    goals_ = given.at("goals");
    for (const auto& [name, value] : scene_.settings) {
        Status allowed = check_setting(name, value);
        if (!allowed) {
            return allowed;
        }
    }
    if (chosen && chosen->step_s > 0.0) {
        set_accuracy(*chosen, scene_);
    } else if (Status kept = choose_accuracy_of(given, root, scene_); !kept) {
        return kept;
    }
    const Result<json> told = ask("choose", accuracy_json(scene_.accuracy));
    return told ? success() : Status(told.error());
}

Result<ExerciseScript> ExerciseScript::open(const CurriculumFiles& files, const std::string& root, std::uint64_t seed) {
    LuaOptions options;
    options.seed = seed;
    options.folders = {{root + "/scripts", "scripts"}, {files.folder, files.id}};
    Result<LuaState> state = LuaState::create(std::move(options));
    if (!state) {
        return state.error();
    }
    ExerciseScript script(std::move(state).value());
    const Status status = script.open_engine();
    return status ? Result<ExerciseScript>(std::move(script)) : status.error();
}

Result<json> ExerciseScript::listing(const CurriculumFiles& files, const std::string& root,
                                     const std::string& language) {
    Result<ExerciseScript> script = open(files, root, 1);
    if (!script) {
        return script.error();
    }
    const Status texts = script.value().read_what_is_shown(files);
    const Result<json> spoken = language.empty() ? Result<json>(json()) : script.value().ask("speak", language);
    if (texts && !spoken) {
        return spoken.error();
    }
    Result<json> made = script.value().run_curriculum(files, "accept_operation");
    if (texts || (made && made.value().is_null())) {
        return made;  // of an exercise, whoever loads it learns of its texts
    }
    return made ? texts.error() : both(made.error(), texts.error());
}

bool ExerciseScript::is_rubric(const CurriculumFiles& files, const std::string& root) {
    Result<ExerciseScript> script = open(files, root, 1);
    if (!script) {
        return false;
    }
    const Result<json> answer = script.value().run_curriculum(files, "is_rubric");
    return answer && answer.value() == true;
}

Result<ExerciseScript> ExerciseScript::load(const CurriculumFiles& files, const std::string& root, std::uint64_t seed,
                                            const std::map<std::string, std::string>& set,
                                            const std::optional<JoinedPart>& joined,
                                            const std::optional<CurriculumFiles>& rubric,
                                            const std::optional<SceneAccuracy>& chosen) {
    Result<ExerciseScript> opened = open(files, root, seed);
    if (!opened) {
        return opened;
    }
    ExerciseScript& script = opened.value();
    if (joined) {
        const Result<json> operation = script.run_curriculum(joined->operation, "accept_operation");
        if (!operation) {
            return operation.error();
        }
    }
    Status status = script.read_what_is_shown(files);
    const Result<json> accepted = script.run_curriculum(files, "accept");
    if (!accepted) {
        status = status ? Status(accepted.error()) : Status(both(accepted.error(), status.error()));
    }
    if (status && joined) {
        status = script.join(*joined);
    }
    if (status && rubric) {
        const Result<json> judged = script.run_curriculum(*rubric, "judge_by");
        status = judged ? success() : Status(judged.error());
    }
    if (status) {
        status = script.apply(set);
    }
    if (status) {
        const Result<json> ready = script.ask("ready");
        status = ready ? success() : Status(ready.error());
    }
    if (status) {
        status = script.read_scene(root, chosen);
    }
    if (!status) {
        return status.error();
    }
    return opened;
}

Result<ExerciseScript> ExerciseScript::load_in_spite(const CurriculumFiles& files, const std::string& root) {
    Result<ExerciseScript> script = open(files, root, 1);
    if (script) {
        const Result<json> ignored = script.value().run_curriculum(files, "accept");
        const Result<json> scene = script.value().ask("scene_in_spite");
        if (!scene) {
            return scene.error();
        }
        script.value().scene_ = scene_from(scene.value());
    }
    return script;
}

Status ExerciseScript::start(const ObservationSchema& schema) {
    return state_.run([&](lua_State* L) {
        push_function(L, "start");
        push_schema(L, schema);
        lua_call(L, 1, 1);
        row_ = LuaRef(state_, L);
        push_function(L, "observe");
        observe_ = LuaRef(state_, L);
    });
}

namespace {

/// Ids of the requests, or nil.
void push_requests(lua_State* L, std::span<const Command> given) {
    std::vector<std::string> asked;
    for (const Command& command : given) {
        if (command.kind == CommandKind::request) {
            asked.push_back(command.name);
        }
    }
    if (asked.empty()) {
        lua_pushnil(L);
    } else {
        lua::push(L, asked);
    }
}

/// Aids as { { name, value, text }, ... }, or nil; likewise an instructor's notes.
void push_told(lua_State* L, std::span<const Command> given, CommandKind kind) {
    json list = json::array();
    for (const Command& command : given) {
        if (command.kind == kind) {
            list.push_back({{"name", command.name}, {"value", command.value}, {"text", command.text}});
        }
    }
    if (list.empty()) {
        lua_pushnil(L);
    } else {
        lua::push_json(L, list);
    }
}

}  // namespace

Result<std::vector<Command>> ExerciseScript::observe(const Observation& observation, std::span<const Command> given) {
    std::vector<Command> commands;
    const Status status = state_.run([&](lua_State* L) {
        row_.push(L);
        lua::fill_row(L, observation);
        lua_pop(L, 1);
        observe_.push(L);
        lua_pushnumber(L, observation.time_s);
        push_requests(L, given);
        push_told(L, given, CommandKind::aid);
        push_told(L, given, CommandKind::note);
        lua_call(L, 4, 1);
        commands = lua::commands_from(L);
        push_function(L, "finished");
        lua_call(L, 0, 1);
        finished_ = lua_toboolean(L, -1) != 0;
    });
    if (!status) {
        finished_ = true;  // a script error ends the exercise; what there is can still be reported
        return status.error();
    }
    return commands;
}

Result<json> ExerciseScript::ask(const char* function, const json& argument) {
    json value;
    const Status status = state_.run([&](lua_State* L) {
        push_function(L, function);
        lua::push_json(L, argument);
        lua_call(L, 1, 1);
        value = lua::to_json(L, -1);
    });
    if (!status) {
        return status.error();
    }
    return value;
}

}  // namespace rhexis
