// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands of the program have in common. Each command is one file with one add_ function.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>

#include "base/result.hpp"

namespace rhexis::cli {

// Exit status of every command.
inline constexpr int done = 0;
inline constexpr int found_failures = 1;  ///< the run, check or test found failures
inline constexpr int bad_input = 2;       ///< bad usage or bad input: one clear line on stderr

/// Where the program finds its scripts, and what the chosen command gives back.
struct Context {
    std::string root;  ///< folder with scripts/, curricula/ and assets/
    int status = done;
};

/// Prints "rhexis: <error>" on stderr, in one line, and returns `status`.
int complain(const Error& error, int status = bad_input);

/// The two sides of what was given as --set KEY=VALUE. example: of a pair, for who gave something else.
Result<std::pair<std::string, std::string>> key_and_value(const std::string& pair, const std::string& command,
                                                          const std::string& example);

/// The option --instruction-set of commands that simulate. Stays empty when it is not given.
void add_instruction_set(CLI::App& command, std::string& instruction_set);

void add_run(CLI::App& app, Context& context);
void add_train(CLI::App& app, Context& context);
void add_monitor(CLI::App& app, Context& context);
void add_lua(CLI::App& app, Context& context);
void add_words(CLI::App& app, Context& context);
void add_check(CLI::App& app, Context& context);
void add_test(CLI::App& app, Context& context);
void add_replay(CLI::App& app, Context& context);
void add_fold(CLI::App& app, Context& context);
void add_bench(CLI::App& app, Context& context);  // only in a program built with the tests
void add_report(CLI::App& app, Context& context);
void add_study(CLI::App& app, Context& context);
void add_track(CLI::App& app, Context& context);
void add_vrpn(CLI::App& app, Context& context);
void add_igtl(CLI::App& app, Context& context);
// Only in a program built with records.
void add_records(CLI::App& app, Context& context);
void add_rate(CLI::App& app, Context& context);

/// The whole program.
int run_program(int argc, const char* const* argv);

}  // namespace rhexis::cli
