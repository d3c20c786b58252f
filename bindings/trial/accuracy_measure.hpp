// SPDX-License-Identifier: GPL-3.0-or-later
// How far off an attempt was: what was recorded is simulated again at twice the resolution, by the same hand.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "base/result.hpp"
#include "trial/attempt.hpp"

namespace rhexis {

/// Twice as fine along each length, as far as meshes may be, and half the step, not under 1 ms.
SceneDescription at_twice_the_resolution(const SceneDescription& scene);

/// Simulates the recording of an attempt so, with the recorded samples, straight between two of them, and the recorded
/// commands. Both are compared up to the first tear, crack or grip that only one of them has for more than 0.1 s.
///   {"mesh": {"patient.tetrahedra": 24000}, "step_s", "compared_s", "of_s",
///    "differs": null or {"time_s", "measure", "attempt", "finer"}, "errors": {"force": 0.2, ...}, "exceeded":
///    ["force"]}
/// errors: those that the attempt told of itself (trial/told_errors.hpp), and of the attempt against the finer one
/// those of quantities that a budget may be about and that both tell of: force in means over 0.1 s, its rms over time
/// as a share of the greatest; path the rms distance of a tear's tip [mm]; depth and pressure the rms over time as a
/// share; volume and tear at the end, as a share. exceeded: those that are more than the scene's budget. Fails for an
/// attempt that began in a state file, which is as fine as it is.
Result<nlohmann::json> measure_accuracy(const std::string& recording, const AttemptOptions& attempt,
                                        const std::map<std::string, double>& told);

}  // namespace rhexis
