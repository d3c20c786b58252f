// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands that begin an attempt have in common: a virtual surgeon's and a person's.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "cli/command.hpp"
#include "cli/kept_attempt.hpp"
#include "trial/attempt.hpp"

namespace rhexis::cli {

struct AttemptArguments {
    std::string curriculum;
    std::string surgeon = "expert";
    std::uint64_t seed = 1;
    std::string patient;
    std::string out;
    std::string start;
    std::string opening;
    std::vector<std::string> set;
    int threads = 1;
    std::string instruction_set;
    double limit_s = 600.0;
    std::string level;
    std::string mode;
    std::string eye;
    std::string hand;
    std::string language;
    KeepOptions keep;
};

/// The last part of a curriculum's path, for names of folders.
std::string exercise_name(const std::string& curriculum);

/// All of them but curriculum and surgeon.
void add_attempt_arguments(CLI::App& command, AttemptArguments& given);

/// Fails on numbers out of range and on names that the store would refuse.
Status check_attempt_arguments(const AttemptArguments& given);

/// What --set, --patient and the options that stand for a setting say.
Result<std::map<std::string, std::string>> given_settings(const AttemptArguments& given, const std::string& root);

/// What holds for an exercise and for every part of an operation.
AttemptOptions attempt_options(const AttemptArguments& given, std::map<std::string, std::string> set,
                               const std::string& root);

/// A trainee's attempt is not written over: the store names its folder.
Status check_folder(const std::string& folder, bool resume);

/// The exercise is loaded first, so that its mistakes show before anything is stored. resume: as KeptAttempt::begin.
Result<KeptAttempt> begin_kept(const AttemptArguments& given, const AttemptOptions& options, bool resume = false);

void print_objectives(const nlohmann::json& report);
/// How many were made, and which.
void print_errors(const nlohmann::json& report);
/// who: operated.
void print_summary(const AttemptArguments& given, const std::string& who, const std::string& folder,
                   const AttemptResult& result);

}  // namespace rhexis::cli
