// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis check: loads exercises and runs them for a moment, so that their mistakes are found by file and line.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "cli/command.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/exercise_host.hpp"
#include "lua/operation_script.hpp"
#include "session/trial.hpp"
#include "trial/accuracy_notes.hpp"
#include "trial/scenario_files.hpp"
#include "trial/scenario_run.hpp"
#include "trial/unused_tissues.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* check_help =
    "Loads each exercise with its starts and scenario tests, builds its scene and lets it watch a moment of it, so "
    "that "
    "wrong names, values and syntax show.\n"
    "\n"
    "  rhexis check curricula/groove\n"
    "  rhexis check my_exercise/ other.lua my_exercise/tests/iris.lua\n"
    "\n"
    "All mistakes are told, each in one line, file:line first: misspelt names with the near ones, settings out of "
    "range,\n"
    "steps that are never reached, conditions that never change, recoveries that can never hold. Then what the "
    "trainee\n"
    "is to learn, the levels, the texts that lack a translation, and notes: what is no mistake of form, but may not "
    "do\n"
    "what was meant.\n"
    "Warnings tell what is simulated for nothing, or more coarsely or dearly than its accuracy wants: tissues that "
    "nothing\n"
    "uses, meshes by hand, and scenes that one core cannot step in real time by the tables in assets/accuracy.\n"
    "A file that is wrong does not hide what is wrong in the files beside it. Of scenario tests it checks form, "
    "exercise, settings and start; rhexis test runs them.";

constexpr int dry_steps = 20;

/// What was found of an exercise that runs.
struct Findings {
    std::vector<std::string> faults;    ///< each a line, "file:line: what"
    std::vector<std::string> notes;     ///< lines that are no faults
    std::vector<std::string> untold{};  ///< texts without a translation
    nlohmann::json scene{};             ///< that it leaves for a part of an operation that continues it
    std::vector<std::string> measured{};
    std::vector<std::string> tissues{};
};

std::vector<std::string> lines_of(const nlohmann::json& found, const char* key) {
    return found.value(key, nlohmann::json::array()).get<std::vector<std::string>>();
}

Result<Findings> review(ExerciseHost& host) {
    const Result<nlohmann::json> found = host.review();
    if (!found) {
        return found.error();
    }
    Findings all;
    all.faults = lines_of(found.value(), "faults");
    all.notes = lines_of(found.value(), "notes");
    all.untold = lines_of(found.value(), "untranslated");
    return all;
}

/// What of a scene costs more than it need, or than there is.
Status add_warnings(ExerciseHost& host, const SceneDescription& scene, Findings& found) {
    for (const std::string& line : accuracy_warnings(scene.accuracy)) {
        found.notes.push_back("warning: " + line);
    }
    const Result<std::vector<std::string>> used = host.used_measures();
    if (!used) {
        return used.error();
    }
    for (const std::string& tissue : unused_tissues(scene, used.value())) {
        found.notes.push_back("warning: tissues: no step, event, measure, score or picture of this exercise uses " +
                              tissue);
    }
    return success();
}

/// An error of a scene that says itself where it comes from, else the exercise.
Error of_exercise(Error error, const ExerciseOptions& options) {
    const Result<CurriculumFiles> files = find_curriculum(options.curriculum, options.root);
    if (error.where.empty() && files) {
        error.where = files.value().chunk;
    }
    return error;
}

Result<Findings> dry_run(const ExerciseOptions& options, bool warn = false) {
    Result<ExerciseHost> host = ExerciseHost::load(options);
    if (!host) {
        return host.error();
    }
    Result<Session> session = Session::create(host.value().scene(), 1);
    if (!session) {
        return of_exercise(session.error(), options);
    }
    LiveTimeline timeline(session.value());
    Nobody nobody;
    const double dry_s = dry_steps * session.value().scene().step_s;
    const Status played = status_of(Trial(timeline, &host.value(), nobody, {}, {dry_s}).run());
    if (!played) {
        return played.error();
    }
    const Result<nlohmann::json> result = host.value().result();
    Result<Findings> found = result ? review(host.value()) : Result<Findings>(result.error());
    if (found) {
        for (const MeasureInfo& measure : session.value().schema()) {
            found.value().measured.push_back(measure.name);
        }
        found.value().tissues = host.value().scene().tissues;
        const Status warned = warn ? add_warnings(host.value(), session.value().scene(), found.value()) : success();
        if (!warned) {
            return warned.error();
        }
        if (result.value().contains("operation")) {
            found.value().scene = result.value()["operation"]["carried"]["scene"];
        }
    }
    return found;
}

/// Mistakes once, however many files show it.
void add_fault(Findings& all, const Error& error) {
    for (const std::string& line : error.lines()) {
        if (std::find(all.faults.begin(), all.faults.end(), line) == all.faults.end()) {
            all.faults.push_back(line);
        }
    }
}

/// The scenario tests in a file: their form, their exercise; with an exercise that loads, what they set and start from.
void check_scenarios(const std::string& path, bool exercise_loads, const Context& context, Findings& all) {
    const Result<ScenarioFile> file = read_scenarios(path, context.root);
    if (!file) {
        add_fault(all, file.error());
        return;
    }
    for (std::size_t i = 0; exercise_loads && i < file.value().scenarios.size(); ++i) {
        const Status good = check_scenario(file.value(), file.value().scenarios.at(i), context.root);
        if (!good) {
            add_fault(all, good.error());
        }
    }
}

/// Whether the part whose opening another one takes over can tear one. tissues: of the parts so far, by id.
Status check_opening(const OperationPart& part, const std::map<std::string, std::vector<std::string>>& tissues) {
    const auto torn = tissues.find(part.opening);
    if (torn == tissues.end() ||
        std::find(torn->second.begin(), torn->second.end(), "anterior_capsule") != torn->second.end()) {
        return success();
    }
    return Error{"part " + part.id + ": opening: part " + part.opening + " tears none", part.where,
                 "a part with the tissue anterior_capsule"};
}

/// Each part as the operation has it, with nothing handed over but the scene, where a part continues the one before it.
Result<Findings> check_operation(const Operation& operation, const Context& context) {
    Findings all;
    std::map<std::string, std::vector<std::string>> tissues;
    nlohmann::json before = {{"measured", nlohmann::json::array()}};
    for (std::size_t i = 0; i < operation.parts.size(); ++i) {
        const OperationPart& part = operation.parts[i];
        Status opening = check_opening(part, tissues);
        if (!opening) {
            return opening.error();
        }
        ExerciseOptions options{part.exercise, "none", 1, {}, context.root};
        options.part = PartPlace{operation.name, static_cast<int>(i) + 1, before};
        const Result<Findings> found = dry_run(options);
        if (!found) {
            for (const std::string& fault : found.error().lines()) {
                all.faults.push_back("part " + part.id + ": " + fault);
            }
            return all;  // what comes after it continues it
        }
        for (const std::string& fault : found.value().faults) {
            all.faults.push_back("part " + part.id + ": " + fault);
        }
        tissues[part.id] = found.value().tissues;
        before["scene"] = found.value().scene;
        for (const std::string& measure : found.value().measured) {
            before["measured"].push_back(measure);
        }
    }
    all.untold = operation.untranslated;
    for (const std::string& objective : operation.objectives) {
        all.notes.push_back("objective: " + objective);
    }
    return all;
}

/// The plan of its virtual surgeon: that it can be read, with what it requires.
Status check_plan(const std::string& path, const Context& context) {
    const Result<CurriculumFiles> files = find_curriculum(path, context.root);
    if (!files || std::filesystem::path(files.value().script).filename() != "curriculum.lua" ||
        !std::filesystem::exists(files.value().folder + "/surgeon.lua")) {
        return success();
    }
    const Result<ExerciseHost> host = ExerciseHost::load({path, "expert", 1, {}, context.root});
    return host ? success() : Status(host.error());
}

/// The form of the scripts beside an exercise that does not load: what they hold is read after it.
void check_form(const std::string& path, const Context& context, Findings& all) {
    const Result<CurriculumFiles> files = find_curriculum(path, context.root);
    if (!files || std::filesystem::path(files.value().script).filename() != "curriculum.lua") {
        return;
    }
    std::error_code failed;
    for (std::filesystem::directory_iterator at(files.value().folder, failed), end; !failed && at != end;
         at.increment(failed)) {
        const std::string name = at->path().filename();
        if (name.ends_with(".lua") && name != "curriculum.lua" && name != "starts.lua") {
            const std::string chunk = files.value().id + "/" + name;
            const Status good = check_form_of(at->path().string(), chunk);
            if (!good) {
                add_fault(all, good.error());
            }
        }
    }
}

/// Its starts and its scenario tests.
void check_beside(const std::string& path, bool exercise_loads, const Context& context, Findings& all) {
    const Result<CurriculumFiles> files = find_curriculum(path, context.root);
    if (!files || std::filesystem::path(files.value().script).filename() != "curriculum.lua") {
        return;  // a lone file: what lies beside it is not its own
    }
    const std::string starts = files.value().folder + "/starts.lua";
    if (std::filesystem::exists(starts)) {
        const Result<ScenarioScript> script = ScenarioScript::load(starts, "starts", context.root);
        if (!script) {
            add_fault(all, script.error());
        }
    }
    for (const std::string& file : scenarios_below(files.value().folder)) {
        check_scenarios(file, exercise_loads, context, all);
    }
}

/// An exercise as it is written, and at each of its levels.
Result<Findings> check_levels(const std::string& path, const Context& context) {
    const Result<ExerciseHost> host = ExerciseHost::load({path, "none", 1, {}, context.root});
    if (!host) {
        return host.error();
    }
    Result<Findings> found = dry_run({path, "none", 1, {}, context.root}, true);
    for (const std::string& level : host.value().levels()) {
        if (!found) {
            break;
        }
        const Result<Findings> harder = dry_run({path, "none", 1, {{"level", level}}, context.root});
        if (!harder) {
            for (const std::string& fault : harder.error().lines()) {
                add_fault(found.value(), Error{"level " + level + ": " + fault, "", ""});
            }
            continue;
        }
        for (const std::string& fault : harder.value().faults) {
            const auto& known = found.value().faults;
            if (std::find(known.begin(), known.end(), fault) == known.end()) {
                found.value().faults.push_back(fault + " (at level " + level + ")");
            }
        }
    }
    return found;
}

/// An exercise with its starts and its scenario tests; or an operation.
Result<Findings> check_exercise(const std::string& path, const Context& context) {
    const Result<std::optional<Operation>> operation = load_operation(path, context.root);
    if (operation && operation.value()) {
        return check_operation(*operation.value(), context);
    }
    const Result<Findings> found = operation ? check_levels(path, context) : Result<Findings>(operation.error());
    Findings all = found ? found.value() : Findings{};
    if (!found) {
        add_fault(all, found.error());
    }
    const Status plan = found ? check_plan(path, context) : success();
    if (!plan) {
        add_fault(all, plan.error());
    }
    if (!found) {
        const ExerciseOptions options{path, "none", 1, {}, context.root};
        const Result<nlohmann::json> more = ExerciseHost::mistakes_in_spite(options);
        for (const nlohmann::json& line : more ? more.value() : nlohmann::json::array()) {
            add_fault(all, Error{line.get<std::string>(), "", ""});
        }
        check_form(path, context, all);
    }
    check_beside(path, static_cast<bool>(found), context, all);
    return all;
}

/// A mistake's line with its file as it is found from where one stands: messages begin with the folder's own name.
std::string placed(const std::string& path, const std::string& line, const Context& context) {
    const Result<CurriculumFiles> files = find_curriculum(path, context.root);
    if (!files) {
        return line;
    }
    std::filesystem::path given = std::filesystem::path(path).lexically_normal();
    if (given.filename() == "curriculum.lua" || !given.has_filename()) {
        given = given.parent_path();  // of "my_exercise/curriculum.lua" and "my_exercise/"
    }
    const std::string own =
        files.value().chunk.ends_with("/curriculum.lua") ? files.value().id + "/" : files.value().chunk + ":";
    if (given.empty() || given == "." || !line.starts_with(own)) {
        return line;
    }
    return given.string() + own.back() + line.substr(own.size());
}

int tell(const std::string& path, const Findings& found, const Context& context) {
    for (const std::string& fault : found.faults) {
        std::fprintf(stderr, "rhexis: %s\n", placed(path, fault, context).c_str());
    }
    if (!found.faults.empty()) {
        return found_failures;
    }
    std::printf("%s: good\n", path.c_str());
    for (const auto* lines : {&found.notes, &found.untold}) {
        for (const std::string& line : *lines) {
            std::printf("  %s\n", line.c_str());
        }
    }
    return done;
}

int check_one(const std::string& path, const Context& context) {
    if (is_scenario_file(std::filesystem::absolute(path).string())) {
        Findings found;
        check_scenarios(path, true, context, found);
        return tell(path, found, context);
    }
    const Result<Findings> checked = check_exercise(path, context);
    Findings found = checked ? checked.value() : Findings{};
    if (!checked) {
        add_fault(found, checked.error());
    }
    return tell(path, found, context);
}

int check(const std::vector<std::string>& paths, const Context& context) {
    int status = done;
    for (const std::string& path : paths) {
        status = std::max(status, check_one(path, context));
    }
    return status;
}

}  // namespace

void add_check(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("check", "Find the mistakes in exercises, by file and line");
    command->footer(check_help);
    auto paths = std::make_shared<std::vector<std::string>>();
    command->add_option("path", *paths, "Exercises: folders, files, or names in curricula/")->required();
    command->callback([paths, &context] { context.status = check(*paths, context); });
}

}  // namespace rhexis::cli
