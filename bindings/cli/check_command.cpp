// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis check: loads exercises and runs them for a moment, so that their mistakes are found by file and line.
#include <cstdio>
#include <filesystem>

#include "cli/command.hpp"
#include "cli/scenario_files.hpp"
#include "cli/scenario_run.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/exercise_host.hpp"
#include "lua/operation_script.hpp"
#include "session/session.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* help =
    "Loads each exercise with its starts and scenario tests, builds its scene and lets it watch a moment of it, so "
    "that "
    "wrong names, values and syntax show.\n"
    "\n"
    "  rhexis check curricula/groove\n"
    "  rhexis check my_exercise/ other.lua my_exercise/tests/iris.lua\n"
    "\n"
    "Of scenario tests it checks form, exercise, settings and start; rhexis test runs them.";

constexpr int dry_steps = 20;

Status dry_run(const ExerciseOptions& options) {
    Result<ExerciseHost> host = ExerciseHost::load(options);
    if (!host) {
        return host.error();
    }
    Result<Session> session = Session::create(host.value().scene(), 1);
    if (!session) {
        return session.error();
    }
    Status started = host.value().start(session.value().schema(), session.value().scene().instruments);
    if (!started) {
        return started;
    }
    for (int step = 0; step <= dry_steps && !host.value().finished(); ++step) {
        const Result<std::vector<Command>> commands = host.value().observe(session.value().observation());
        if (!commands) {
            return commands.error();
        }
        session.value().step({}, commands.value());
    }
    const Result<nlohmann::json> result = host.value().result();
    return result ? success() : Status(result.error());
}

/// The scenario tests in a file: their form, their exercise, what they set and start from.
Status check_scenarios(const std::string& path, const Context& context) {
    const Result<ScenarioFile> file = read_scenarios(path, context.root);
    if (!file) {
        return file.error();
    }
    for (const nlohmann::json& scenario : file.value().scenarios) {
        Status good = check_scenario(file.value(), scenario, context.root);
        if (!good) {
            return good;
        }
    }
    return success();
}

/// Each part as the operation has it, with nothing handed over.
Status check_operation(const Operation& operation, const Context& context) {
    for (std::size_t i = 0; i < operation.parts.size(); ++i) {
        const OperationPart& part = operation.parts[i];
        ExerciseOptions options{part.exercise, "none", 1, {}, context.root};
        options.part = PartPlace{operation.name, static_cast<int>(i) + 1};
        const Status runs = dry_run(options);
        if (!runs) {
            return Error{"part " + part.id + ": " + runs.error().text(), part.where, ""};
        }
    }
    return success();
}

/// An exercise with its starts and its scenario tests; or an operation.
Status check_exercise(const std::string& path, const Context& context) {
    const Result<std::optional<Operation>> operation = load_operation(path, context.root);
    if (!operation || operation.value()) {
        return operation ? check_operation(*operation.value(), context) : Status(operation.error());
    }
    const Status runs = dry_run({path, "none", 1, {}, context.root});
    const Result<CurriculumFiles> files = find_curriculum(path, context.root);
    if (!runs || !files) {
        return runs ? Status(files.error()) : runs;
    }
    if (std::filesystem::path(files.value().script).filename() != "curriculum.lua") {
        return success();  // a lone file: what lies beside it is not its own
    }
    const std::string starts = files.value().folder + "/starts.lua";
    if (std::filesystem::exists(starts)) {
        const Result<ScenarioScript> script = ScenarioScript::load(starts, "starts", context.root);
        if (!script) {
            return script.error();
        }
    }
    for (const std::string& file : scenarios_below(files.value().folder)) {
        Status good = check_scenarios(file, context);
        if (!good) {
            return good;
        }
    }
    return success();
}

int check(const std::vector<std::string>& paths, const Context& context) {
    int status = done;
    for (const std::string& path : paths) {
        const Status checked = is_scenario_file(std::filesystem::absolute(path).string())
                                   ? check_scenarios(path, context)
                                   : check_exercise(path, context);
        if (checked) {
            std::printf("%s: good\n", path.c_str());
        } else {
            status = complain(checked.error(), found_failures);
        }
    }
    return status;
}

}  // namespace

void add_check(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("check", "Find the mistakes in exercises, by file and line");
    command->footer(help);
    auto paths = std::make_shared<std::vector<std::string>>();
    command->add_option("path", *paths, "Exercises: folders, files, or names in curricula/")->required();
    command->callback([paths, &context] { context.status = check(*paths, context); });
}

}  // namespace rhexis::cli
