// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis words: every name that an exercise may use, for who writes one.
#include <algorithm>
#include <cctype>
#include <cstdio>

#include "cli/command.hpp"
#include "lua/exercise_host.hpp"
#include "session/session.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* words_help =
    "Measures are those of the exercise's own tissues and instruments; settings are all that there are. Words after "
    "the\n"
    "exercise choose the lines that hold all of them. Of an exercise with mistakes there is what can be read of it.\n"
    "\n"
    "  rhexis words my_exercise/               everything\n"
    "  rhexis words my_exercise/ iris          what has to do with the iris\n"
    "  rhexis words my_exercise/ vacuum panel\n"
    "  rhexis words groove item                the items of the rubric, and which are scored there";

struct WordsArguments {
    std::string exercise;
    std::vector<std::string> chosen;
};

std::string in_small_letters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

Result<nlohmann::json> vocabulary_of(const std::string& exercise, const Context& context) {
    Result<ExerciseHost> host = ExerciseHost::load({exercise, "none", 1, {}, context.root});
    if (!host) {
        return host.error();
    }
    Result<Session> session = Session::create(host.value().scene(), 1);
    if (!session) {
        return session.error();
    }
    const Status started = host.value().start(session.value().schema(), session.value().scene().instruments);
    return started ? host.value().vocabulary() : Result<nlohmann::json>(started.error());
}

/// The lines that hold all the chosen words, under the title of their kind.
int print_chosen(const nlohmann::json& kinds, const std::vector<std::string>& chosen) {
    int printed = 0;
    for (const nlohmann::json& kind : kinds) {
        std::string lines;
        for (const nlohmann::json& line : kind.at("lines")) {
            const std::string text = line.at("text");
            const std::string small = in_small_letters(text);
            if (std::all_of(chosen.begin(), chosen.end(), [&](const std::string& word) {
                    return small.find(in_small_letters(word)) != std::string::npos;
                })) {
                lines += "  " + text + "\n";
                ++printed;
            }
        }
        if (!lines.empty()) {
            std::printf("%s\n%s", kind.at("title").get<std::string>().c_str(), lines.c_str());
        }
    }
    return printed;
}

int words(const WordsArguments& given, const Context& context) {
    const Result<nlohmann::json> whole = vocabulary_of(given.exercise, context);
    const Result<nlohmann::json> kinds =
        whole ? whole : ExerciseHost::vocabulary_in_spite({given.exercise, "none", 1, {}, context.root});
    if (!kinds) {
        return complain(whole.error());
    }
    const int printed = print_chosen(kinds.value(), given.chosen);
    if (!whole) {  // last, where it is seen
        return complain(whole.error());
    }
    if (printed == 0) {
        return complain({"no line holds all of these words", "words", "fewer or shorter ones"}, found_failures);
    }
    return done;
}

}  // namespace

void add_words(CLI::App& app, Context& context) {
    CLI::App* command =
        app.add_subcommand("words", "Every measure, setting and item that an exercise may name, with its meaning");
    command->footer(words_help);
    auto given = std::make_shared<WordsArguments>();
    command->add_option("exercise", given->exercise, "Folder, file, or name of one in curricula/")->required();
    command->add_option("word", given->chosen, "Only lines that hold all of these");
    command->callback([given, &context] { context.status = words(*given, context); });
}

}  // namespace rhexis::cli
