// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/starts.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/hash.hpp"
#include "base/near_names.hpp"
#include "base/text_file.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/exercise_host.hpp"
#include "lua/scenario_script.hpp"
#include "session/accuracy_quantities.hpp"
#include "session/build_world.hpp"
#include "session/prepared_state.hpp"
#include "session/settings.hpp"
#include "trial/folded_implant.hpp"
#include "trial/kept_states.hpp"
#include "trial/opening_files.hpp"
#include "trial/places.hpp"
#include "trial/scenario_run.hpp"
#include "trial/trial_progress.hpp"
#include "trial/virtual_surgeon.hpp"

namespace rhexis {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// How an exercise says that a state is made.
struct Recipe {
    std::string name;
    CurriculumFiles files;
    json text;  ///< {"surgeon", "seed", "set", "when", "limit_s", "opening", "where", "by_hand"}
    std::map<std::string, std::string> set;
    std::vector<double> opening{};  ///< of the bag, as SceneDescription has it
    std::string fingerprint{};      ///< of everything that the state depends on
};

bool is_file(const std::string& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

/// Names in starts.lua have neither dots nor slashes; all else is a file.
bool is_name(const std::string& start) { return start.find_first_of("./") == std::string::npos; }

/// A value that decides what is built, which the state and the run that starts from it must share.
bool builds_the_scene(const std::string& name) {
    const SettingInfo* setting = find_setting(name);
    return name.starts_with("patient.") || name.starts_with("accuracy.") || name == "level" || name == "step_s" ||
           name == "advance" || (setting != nullptr && !setting->live);
}

std::map<std::string, std::string> of_the_scene(std::map<std::string, std::string> set) {
    std::erase_if(set, [](const auto& entry) { return !builds_the_scene(entry.first); });
    return set;
}

std::vector<std::string> names_of(const json& starts) {
    std::vector<std::string> names;
    for (const auto& [name, recipe] : starts.items()) {
        names.push_back(name);
    }
    return names;
}

/// Of the tables that say how finely a scene is simulated.
json hashes_of_tables(const std::string& root) {
    constexpr std::size_t most_bytes = std::size_t{1} << 20;
    json hashes = json::array();
    for (const AccuracyModel& model : accuracy_models()) {
        const Result<std::string> text =
            read_text_file(root + "/assets/accuracy/" + std::string(model.tissue) + ".csv", most_bytes);
        hashes.push_back(text ? sha256_hex(text.value()) : "");
    }
    return hashes;
}

/// Everything that may change what a run comes to: scripts, program, tables, recipe.
Result<std::string> fingerprint_of(const Recipe& recipe, const std::string& root) {
    const Result<std::string> scripts = hash_of_scripts(root + "/scripts");
    if (!scripts) {
        return scripts.error();
    }
    const Result<std::string> program = hash_of_program();
    if (!program) {
        return program.error();
    }
    const json parts = {recipe.files.sha256, scripts.value(), program.value(), build_note(),
                        recipe.text,         recipe.set,      recipe.opening,  hashes_of_tables(root)};
    return sha256_hex(parts.dump());
}

Result<Recipe> find_recipe(const StartRequest& request) {
    const Result<CurriculumFiles> files = find_curriculum(request.curriculum, request.root);
    if (!files) {
        return files.error();
    }
    Recipe recipe{request.start, files.value(), {}, {}};
    const std::string path = files.value().folder + "/starts.lua";
    if (!is_file(path)) {
        return Error{"there is no start '" + request.start + "'", files.value().id,
                     "a state file; the exercise prepares none (it has no starts.lua)"};
    }
    const Result<ScenarioScript> script = ScenarioScript::load(path, "starts", request.root);
    if (!script) {
        return script.error();
    }
    const json& starts = script.value().listing();
    if (!starts.contains(request.start)) {
        return Error{"there is no start '" + request.start + "'", files.value().id,
                     suggestion(request.start, names_of(starts))};
    }
    recipe.text = starts.at(request.start);
    recipe.set = of_the_scene(request.set);
    recipe.set.merge(recipe.text.at("set").get<std::map<std::string, std::string>>());
    return recipe;
}

RecordingHeader header_of(const Recipe& recipe, json identity, const Session& session) {
    identity["start"] = {{"name", recipe.name}, {"fingerprint", recipe.fingerprint}};
    RecordingHeader header = rhexis::header_of(session);
    header.seed = recipe.text.at("seed");
    header.curriculum = recipe.files.id;
    header.identity = identity.dump();
    header.surgeon = recipe.text.at("surgeon");
    header.set = recipe.set;
    return header;
}

/// Stops a trial at the moment that a recipe waits for.
class UntilItsMoment final : public TrialObserver {
public:
    UntilItsMoment(const Recipe& recipe, ExerciseHost& host) : recipe_(recipe), host_(host) {}

    Status begun(Timeline&) override {
        watched_ = host_.watch(recipe_.text.at("when"), recipe_.text.at("where"));
        return success();
    }
    Status look(Moment& moment) override {
        const Result<bool> now = watched_ ? host_.reached() : watched_.error();
        if (!now) {
            return now.error();
        }
        came_ = now.value();
        moment.stop = came_;
        return success();
    }
    [[nodiscard]] bool came() const { return came_; }

private:
    const Recipe& recipe_;
    ExerciseHost& host_;
    Status watched_ = success();
    bool came_ = false;
};

Error too_late(const Recipe& recipe, double time_s) {
    char time[32];
    std::snprintf(time, sizeof time, "%.1f s", time_s);
    return Error{"start " + recipe.name + ": its moment did not come in " + time, recipe.text.at("where"),
                 "when = \"" + recipe.text.at("when").get<std::string>() + "\""};
}

/// The session as the recipe's surgeon leaves it at that moment.
Result<Session> play_until(const Recipe& recipe, ExerciseHost& host, Session session, bool quiet) {
    LiveTimeline timeline(session);
    VirtualSurgeon surgeon(host);
    UntilItsMoment until(recipe, host);
    const double limit_s = recipe.text.at("limit_s");
    TrialProgress progress("preparing " + recipe.name, quiet, limit_s);
    const Status played = status_of(Trial(timeline, &host, surgeon, {&until, &progress}, {limit_s}).run());
    if (!played) {
        return played.error();
    }
    return until.came() ? Result<Session>(std::move(session)) : too_late(recipe, session.time_s());
}

/// The session as the hand or the surgeon of the recipe leaves it.
Result<Session> play(const Recipe& recipe, ExerciseHost host, Session session, const StartRequest& request) {
    if (!recipe.text.at("by_hand").get<bool>()) {
        return play_until(recipe, host, std::move(session), request.quiet);
    }
    Result<ScenarioScript> script = ScenarioScript::load(recipe.files.folder + "/starts.lua", "starts", request.root);
    if (!script) {
        return script.error();
    }
    return play_start(std::move(host), std::move(session), std::move(script).value(), recipe.name);
}

Result<ExerciseHost> load_host(const Recipe& recipe, const StartRequest& request) {
    Result<ExerciseHost> host =
        ExerciseHost::load({recipe.files.script, recipe.text.at("surgeon"), recipe.text.at("seed").get<std::uint64_t>(),
                            recipe.set, request.root});
    if (!host) {
        const std::string where = host.error().where.empty() ? "" : host.error().where + ": ";
        return Error{"start " + recipe.name + ": " + where + host.error().what, recipe.text.at("where"),
                     host.error().allowed};
    }
    return host;
}

/// What a scene begins with: the implant in its injector, or "", the eye at rest.
Result<std::string> before(const SceneDescription& scene, bool quiet) {
    return injects(scene) ? find_folded_implant(scene, quiet) : Result<std::string>(std::string());
}

/// The same of a recipe, with its name and line where it cannot be.
Result<std::string> before(const Recipe& recipe, const ExerciseHost& host, const StartRequest& request) {
    const Result<std::string> path = before(host.scene(), request.quiet);
    return path ? path
                : Error{"start " + recipe.name + ": " + path.error().what, recipe.text.at("where"),
                        path.error().allowed};
}

/// Nobody has to do anything for it.
bool happens_by_itself(const Recipe& recipe) {
    return !recipe.text.at("by_hand").get<bool>() && !recipe.text.contains("when");
}

Status make(const Recipe& recipe, const StartRequest& request, const std::string& path) {
    Result<ExerciseHost> host = load_host(recipe, request);
    if (!host) {
        return host.error();
    }
    const Result<std::string> begun = before(recipe, host.value(), request);
    if (!begun) {
        return begun.error();
    }
    SceneDescription scene = host.value().scene();
    scene.opening = recipe.opening;
    Result<Session> session = create_session(scene, recipe.text.at("seed").get<std::uint64_t>(), begun.value());
    if (!session) {
        return session.error();
    }
    const json identity = host.value().identity();
    const Result<Session> made = play(recipe, std::move(host).value(), std::move(session).value(), request);
    if (!made) {
        return made.error();
    }
    return write_state(path, {header_of(recipe, identity, made.value()), made.value().copy_state()});
}

/// Whether a kept state is what the recipe would make.
bool still_good(const std::string& path, const Recipe& recipe) {
    const Result<PreparedState> kept = is_file(path) ? read_state(path) : Error{};
    if (!kept) {
        return false;
    }
    const json identity = json::parse(kept.value().made.identity, nullptr, false);
    return identity.is_object() && identity.value("/start/fingerprint"_json_pointer, "") == recipe.fingerprint;
}

/// The start in starts.lua at which a run begins that names none.
constexpr const char* first_moment = "begin";

Result<StartRequest> default_start(StartRequest request) {
    if (!request.start.empty()) {
        return request;
    }
    const Result<CurriculumFiles> files = find_curriculum(request.curriculum, request.root);
    if (!files) {
        return files.error();
    }
    const std::string path = files.value().folder + "/starts.lua";
    if (is_file(path)) {
        const Result<ScenarioScript> script = ScenarioScript::load(path, "starts", request.root);
        if (!script) {
            return script.error();
        }
        request.start = script.value().listing().contains(first_moment) ? first_moment : "";
    }
    return request;
}

/// Finds the opening of a recipe: what is asked for, or what the recipe says, beside its file first.
Status open_bag(const StartRequest& request, Recipe& recipe) {
    std::string given = request.opening;
    if (given.empty()) {
        given = recipe.text.value("opening", "");
        const fs::path beside = fs::path(recipe.files.folder) / given;
        std::error_code ignored;
        given = !given.empty() && fs::exists(beside, ignored) ? beside.string() : given;
    }
    if (request.tears && !given.empty()) {
        return Error{"start " + recipe.name + " takes its opening from elsewhere: none can be taken from it",
                     recipe.text.at("where"), "a start in which a capsulorhexis is torn"};
    }
    Result<std::vector<double>> opening = opening_from(given, request);
    if (!opening) {
        const bool own = request.opening.empty();
        const std::string where = opening.error().where.empty() ? "" : opening.error().where + ": ";
        return own ? Error{"start " + recipe.name + ": opening: " + where + opening.error().what,
                           recipe.text.at("where"), opening.error().allowed}
                   : opening.error();
    }
    recipe.opening = std::move(opening).value();
    return success();
}

/// The state of a recipe for which nobody has to do anything: "" or the folded implant.
Result<std::string> at_once(const Recipe& recipe, const StartRequest& request) {
    const Result<ExerciseHost> host = load_host(recipe, request);
    return host ? before(recipe, host.value(), request) : host.error();
}

/// The same of a run that names no start. What is wrong with its exercise is found when it is loaded.
Result<std::string> at_rest(const StartRequest& request) {
    const Result<ExerciseHost> host =
        ExerciseHost::load({request.curriculum, "none", 1, of_the_scene(request.set), request.root});
    return host ? before(host.value().scene(), request.quiet) : Result<std::string>(std::string());
}

/// The state that a recipe's surgeon or hand leaves, made if none is kept that is still good.
Result<std::string> kept(Recipe& recipe, const StartRequest& request) {
    const Result<std::string> fingerprint = fingerprint_of(recipe, request.root);
    if (!fingerprint) {
        return fingerprint.error();
    }
    recipe.fingerprint = fingerprint.value();
    // one file per exercise, start and set: what was made by older scripts is overwritten
    const std::string opening = recipe.opening.empty() ? "" : json(recipe.opening).dump();
    const std::string variant = sha256_hex(recipe.files.script + json(recipe.set).dump() + opening);
    const Result<std::string> folder = folder_of_states();
    if (!folder) {
        return folder.error();
    }
    const std::string path =
        folder.value() + "/" + recipe.files.id + "-" + request.start + "-" + variant.substr(0, 12) + ".rhxs";
    const Turn turn(path);
    if (!still_good(path, recipe)) {
        if (Status made = make(recipe, request, path); !made) {
            return made.error();
        }
    }
    return path;
}

}  // namespace

Status check_start(const StartRequest& given) {
    const Result<StartRequest> found = default_start(given);
    if (!found || found.value().start.empty()) {
        return found ? success() : Status(found.error());
    }
    const StartRequest& request = found.value();
    if (!is_name(request.start)) {
        const Result<PreparedState> state = read_state(request.start);
        return state ? success() : Status(state.error());
    }
    const Result<Recipe> recipe = find_recipe(request);
    return recipe ? success() : Status(recipe.error());
}

namespace {

Result<Start> start_for(const StartRequest& request) {
    if (request.start.empty() || !is_name(request.start)) {
        Result<std::vector<double>> opening = opening_from(request.opening, request);
        if (!opening) {
            return opening.error();
        }
        const Result<std::string> state = request.start.empty() ? at_rest(request) : request.start;
        return state ? Result<Start>(Start{state.value(), std::move(opening).value(), {}, {}}) : state.error();
    }
    Result<Recipe> recipe = find_recipe(request);
    if (!recipe) {
        return recipe.error();
    }
    if (Status open = open_bag(request, recipe.value()); !open) {
        return open.error();
    }
    const Result<std::string> state =
        happens_by_itself(recipe.value()) ? at_once(recipe.value(), request) : kept(recipe.value(), request);
    return state ? Result<Start>(Start{state.value(), recipe.value().opening, {}, {}}) : state.error();
}

}  // namespace

Result<Start> find_start(const StartRequest& given) {
    const Result<StartRequest> found = default_start(given);
    if (!found) {
        return found.error();
    }
    Result<Start> start = start_for(found.value());
    if (start && given.start != first_moment) {
        start.value().chosen = given.start;
    }
    return start;
}

}  // namespace rhexis
