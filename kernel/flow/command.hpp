// SPDX-License-Identifier: GPL-3.0-or-later
// curriculum, surgeon -> session: what a script wants, read at the start of the next step.
#pragma once

#include <string>

namespace rhexis {

enum class CommandKind {
    set,      ///< name = "phaco.power_limit", value in its range
    say,      ///< text for the trainee
    picture,  ///< keep a picture of this moment for the report; name is its caption key, text the caption
    finish,   ///< end the exercise; text is the reason
    request,  ///< whoever operates asks the staff for something, or declares it; name is its id in the exercise. Input
              ///< as samples are: the exercise, not the session, says what follows
    adjust,   ///< whoever operates turns a dial of the machine: as `set`, but input, as samples are
    aid,      ///< whoever operates was helped, or hindered: name = "rewound", "slowed", "guided", "warned" or
              ///< "injected", value = seconds of it, text = what of it. Input: the attempt is judged as one with aids
    inject,   ///< an instructor lets something happen: as `set`, but input
    note      ///< an instructor pins text to this moment. Input
};

struct Command {
    CommandKind kind = CommandKind::say;
    std::string name;
    double value = 0.0;
    std::string text;
};

/// Of whoever operates or instructs, not of the exercise.
inline bool is_input(const Command& command) {
    return command.kind == CommandKind::request || command.kind >= CommandKind::adjust;
}

}  // namespace rhexis
