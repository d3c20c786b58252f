// SPDX-License-Identifier: GPL-3.0-or-later
// What a session really holds: so that a test can say that it is no more than its scene needs.
#pragma once

#include <string>
#include <vector>

#include "session/session.hpp"

namespace rhexis::scenes {

/// Names of tissues and bodies, sorted.
struct SceneParts {
    std::vector<std::string> built;    ///< that have a model in the world
    std::vector<std::string> stepped;  ///< that a step has spent time on so far, by the session's profile
    std::vector<std::string> drawn;    ///< that a picture of this moment is given
};

SceneParts parts_of(const Session& session);

}  // namespace rhexis::scenes
