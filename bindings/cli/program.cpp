// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <vector>

#include "base/near_names.hpp"
#include "cli/command.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* description =
    "rhexis: a scriptable simulation kernel for training in cataract surgery.\n"
    "\n"
    "Start here:\n"
    "  rhexis run groove                     a virtual expert sculpts a groove; report, pictures, recording in runs/\n"
    "  rhexis run groove --surgeon novice    the same by a beginner\n"
    "  rhexis train groove                   you do it, with mouse and keys\n"
    "  rhexis replay runs/groove-expert-1 --verify\n"
    "                                        simulate that again and compare every step, bit for bit\n"
    "  rhexis check my_exercise/             find the mistakes in an exercise of your own, by file and line\n"
    "  rhexis words my_exercise/             every measure, setting and item that it may name, with its meaning\n"
    "  rhexis test groove                    run the scenario tests of an exercise\n"
#ifdef RHEXIS_WITH_RECORDS
    "  rhexis records --help                 keep the attempts of trainees, learning curves, gates\n"
#endif
    "  rhexis lua my_scene.lua               run a script with the kernel's modules at hand\n";

constexpr const char* footer =
    "Exit status: 0 done; 1 the run, check or test found failures; 2 bad usage or bad input.\n"
    "Scripts and exercises are found beside the program, or in the folder that RHEXIS_HOME names. --cache, for any\n"
    "command, or RHEXIS_CACHE names the folder in which states to start from are kept, else ~/.cache/rhexis.";

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

/// The words that are no options; the first is the command that was meant.
std::vector<std::string> words_of(int argc, const char* const* argv) {
    std::vector<std::string> words;
    for (int i = 1; i < argc; ++i) {
        if (argv[i][0] != '-') {
            words.emplace_back(argv[i]);
        }
    }
    return words;
}

/// A file of a command that takes one where others have their commands: rhexis track CONFIG.
bool is_file_of(const CLI::App& command, const std::string& word) {
    const std::vector<const CLI::Option*> options = command.get_options();
    return word.find_first_of("./") != std::string::npos &&
           std::any_of(options.begin(), options.end(), [](const CLI::Option* one) { return one->get_positional(); });
}

/// A misspelt option of a command, with its near names; CLI11 alone only says that it does not know it.
Error usage_error(const CLI::App& app, const CLI::ParseError& error, int argc, const char* const* argv) {
    const CLI::App* command = &app;
    std::string name;
    std::vector<std::string> options;
    for (const std::string& word : words_of(argc, argv)) {  // rhexis records list
        const std::vector<std::string> commands = command_names(*command);
        if (commands.empty() || is_file_of(*command, word)) {
            break;
        }
        if (std::find(commands.begin(), commands.end(), word) == commands.end()) {
            return {"there is no command " + word, name, suggestion(word, commands)};
        }
        command = command->get_subcommand(word);
        const std::vector<std::string> own = option_names(*command);
        options.insert(options.end(), own.begin(), own.end());
        name.append(name.empty() ? "" : " ").append(word);
    }
    if (name.empty()) {
        return {error.what(), "", "rhexis --help shows what there is"};
    }
    for (int i = 1; i < argc; ++i) {
        const std::string given = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
        if (given.starts_with("--") && std::find(options.begin(), options.end(), given) == options.end()) {
            return {"there is no option " + given, name, suggestion(given, options)};
        }
    }
    return {error.what(), name, "rhexis " + name + " --help shows how"};
}

int parse_and_run(CLI::App& app, Context& context, int argc, const char* const* argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        return complain(usage_error(app, error, argc, argv));
    }
    return context.status;
}

}  // namespace

int complain(const Error& error, int status) {
    std::string line = error.lines().front();
    if (!error.more.empty()) {
        line += " (and " + std::to_string(error.more.size()) + " more, which rhexis check tells)";
    }
    std::replace(line.begin(), line.end(), '\n', ' ');
    std::fprintf(stderr, "rhexis: %s\n", line.c_str());
    return status;
}

Result<std::pair<std::string, std::string>> key_and_value(const std::string& pair, const std::string& command,
                                                          const std::string& example) {
    const std::size_t equals = pair.find('=');
    if (equals == std::string::npos || equals == 0) {
        return Error{"--set " + pair + " has no value", command, "--set key=value, as in --set " + example};
    }
    return std::pair(pair.substr(0, equals), pair.substr(equals + 1));
}

void add_instruction_set(CLI::App& command, std::string& instruction_set) {
    command
        .add_option("--instruction-set", instruction_set,
                    "Of the kernel's loops; the result does not depend on it [the best of this machine]")
        ->check(CLI::IsMember({"baseline", "avx2", "avx512"}));
}

/// The results that were printed have gone where they should. A full disk shows only when the last of them is written.
void check_printed() {
    std::cout.flush();
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good()) {
        return;
    }
    std::fprintf(stderr, "rhexis: not all of the output could be written%s%s\n", errno != 0 ? ": " : "",
                 errno != 0 ? std::strerror(errno) : "");
    std::_Exit(bad_input);  // whatever status it was to be
}

int run_program(int argc, const char* const* argv) {
    std::atexit(check_printed);  // also where a script ends the program
    Context context;
    CLI::App app(description);
    app.footer(footer);
    app.fallthrough();
    app.add_option_function<std::string>(
        "--cache", [](const std::string& folder) { ::setenv("RHEXIS_CACHE", folder.c_str(), 1); },
        "Folder for states that are kept for the next time [RHEXIS_CACHE, or the user's cache]");
    app.set_version_flag("--version", std::string("rhexis ") + RHEXIS_VERSION);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    for (auto* add : {add_run, add_train, add_monitor, add_lua, add_check, add_words, add_test, add_replay, add_report,
                      add_fold, add_study, add_track, add_vrpn, add_igtl}) {
        add(app, context);
    }
#ifdef RHEXIS_WITH_RECORDS
    add_rate(app, context);
    add_records(app, context);
#endif
#ifdef RHEXIS_WITH_BENCHMARKS
    add_bench(app, context);
#endif
    try {
        context.root = find_root();
        return parse_and_run(app, context, argc, argv);
    } catch (const std::bad_alloc&) {
        return complain({"out of memory", "", ""});
    } catch (const std::exception& error) {
        return complain({std::string("internal error: ") + error.what(), "", "please report it with the command line"});
    }
}

}  // namespace rhexis::cli
