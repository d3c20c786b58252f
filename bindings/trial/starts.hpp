// SPDX-License-Identifier: GPL-3.0-or-later
// States that an exercise prepares to start from: declared in its starts.lua, made when they are asked for, and kept.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis {

struct StartRequest {
    std::string curriculum;  ///< as for rhexis run
    std::string start;  ///< name in starts.lua; with a dot or slash in it, a state file; "": "begin", if it is there
    std::map<std::string, std::string> set;  ///< of the run that is to start; its patient and fixed settings count
    std::string root;
    bool quiet = false;     ///< no progress
    std::string opening{};  ///< where that of the bag was torn, as --opening says; "": as the start says
    bool tears = false;     ///< an opening is to be taken from the start, which so cannot take one itself
};

/// What a run begins with.
struct Start {
    std::string state{};            ///< path; "": the eye at rest
    std::vector<double> opening{};  ///< of the bag, as SceneDescription has it
    std::string chosen{};           ///< moment that was asked for in place of the exercise's beginning; "": none was
    std::string opening_note{};     ///< why it is not the one that was torn before; empty: nothing to say
};

/// The state is the file itself, or the one that is kept (kept_states.hpp), which is made again when it is missing or
/// was made by other scripts, another program or for another patient.
Result<Start> find_start(const StartRequest& request);

/// Fails when the exercise has no such start, or the file is no good; makes nothing.
Status check_start(const StartRequest& request);

}  // namespace rhexis
