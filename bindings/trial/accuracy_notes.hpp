// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be said of how finely a scene is simulated, in lines.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "flow/accuracy.hpp"

namespace rhexis {

/// "anterior capsule: capsule.triangles = 1500; expected force 0.13 (0.15), path 0.17 mm (0.2), ...": a line for each
/// model, of its way, mesh, expected errors and, in brackets, what they may be; and one for the step.
std::vector<std::string> accuracy_lines(const SceneAccuracy& accuracy);

/// Warnings: a model that is finer or coarser by hand than its budget wants, and a scene that costs more than real
/// time.
std::vector<std::string> accuracy_warnings(const SceneAccuracy& accuracy);

/// What measure_accuracy found, as one line.
std::string measured_line(const nlohmann::json& measured);

}  // namespace rhexis
