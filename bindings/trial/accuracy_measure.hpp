// SPDX-License-Identifier: GPL-3.0-or-later
// How far off an attempt was: what was recorded is simulated again at twice the resolution, by the same hand.
#pragma once

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
/// errors: of the attempt against the finer one, of quantities that a budget may be about and that both tell of;
/// exceeded: those that are more than the scene's budget. Fails for an attempt that began in a state file, which is as
/// fine as it is.
Result<nlohmann::json> measure_accuracy(const std::string& recording, const AttemptOptions& attempt);

}  // namespace rhexis
