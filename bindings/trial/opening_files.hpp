// SPDX-License-Identifier: GPL-3.0-or-later
// Where the opening of a bag was torn: a state, a recording, the folder of a run, or a start of another exercise.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "trial/starts.hpp"

namespace rhexis {

/// Radii of the opening that was torn there (SceneDescription::opening); none where nothing is given. "EXERCISE:START"
/// is made for the patient of the request. Fails where the request sets the diameter of a circle too.
Result<std::vector<double>> opening_from(const std::string& given, const StartRequest& request);

}  // namespace rhexis
