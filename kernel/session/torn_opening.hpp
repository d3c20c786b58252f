// SPDX-License-Identifier: GPL-3.0-or-later
// The opening that a run of a capsulorhexis has left, for the bag of a scene that an implant is laid into.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "session/session.hpp"

namespace rhexis {

struct TornOpening {
    std::vector<double> radii{};   ///< from the axis to its edge, at rest [mm] (SceneDescription::opening)
    std::optional<Error> unfit{};  ///< why a bag cannot have it: not closed, not about the axis, too wide or narrow
};

/// In a session's anterior capsule. Fails where there is none.
Result<TornOpening> torn_opening(const Session& session);

/// The same of a state (.rhxs), or of the last whole step of a recording (.rhx), which may be cut short. Errors, and
/// `unfit`, name the path.
Result<TornOpening> read_torn_opening(const std::string& path);

}  // namespace rhexis
