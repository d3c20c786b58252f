// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis lua: the user's own script, with the kernel's modules at hand and no sandbox around it.
#include <cstdio>

#include "cli/command.hpp"
#include "lua/script.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* lua_help =
    "The script runs with your own rights (files, programs, network): it is not sandboxed, as exercises are. Beside "
    "Lua's\n"
    "libraries it finds rhexis.mesh, rhexis.scene, rhexis.render and rhexis.eye, and its arguments in `arg` and "
    "`...`.\n"
    "\n"
    "  rhexis lua poke.lua\n"
    "  rhexis lua poke.lua 0.5 picture.png";

struct LuaArguments {
    std::string file;
    std::vector<std::string> arguments;
    ScriptOptions options;
};

int run_lua(const LuaArguments& given) {
    const ScriptOutcome outcome = run_script(given.file, given.arguments, given.options);
    std::fflush(stdout);
    if (!outcome.traceback.empty()) {
        std::fprintf(stderr, "%s\n", outcome.traceback.c_str());
    }
    return outcome.error.empty() ? outcome.exit_status : complain({outcome.error, "", ""}, outcome.exit_status);
}

}  // namespace

void add_lua(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("lua", "Run your own Lua script with the kernel's modules (not sandboxed)");
    command->footer(lua_help);
    auto given = std::make_shared<LuaArguments>();
    command->add_option("file", given->file, "The script")->required();
    command->add_option("arg", given->arguments, "Its arguments");
    command->add_option("--seed", given->options.seed, "Seed of math.random")->capture_default_str();
    command->add_flag("--verbose", given->options.verbose, "Show the call stack of an error");
    command->positionals_at_end(true);
    command->callback([given, &context] { context.status = run_lua(*given); });
}

}  // namespace rhexis::cli
