// SPDX-License-Identifier: GPL-3.0-or-later
// The opening that a run of a capsulorhexis has left, for the bag of a scene that an implant is laid into.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "session/session.hpp"

namespace rhexis {

/// How far the edge of the opening in a session's anterior capsule is from the axis, at rest [mm]
/// (SceneDescription::opening). Fails where there is no anterior capsule, no closed opening about the axis, or one that
/// a bag cannot have (eye/empty_bag.hpp).
Result<std::vector<double>> torn_opening(const Session& session);

/// The same of a state (.rhxs), or of the last whole step of a recording (.rhx), which may be cut short. Errors name
/// the path.
Result<std::vector<double>> read_torn_opening(const std::string& path);

}  // namespace rhexis
