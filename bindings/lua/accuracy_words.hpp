// SPDX-License-Identifier: GPL-3.0-or-later
// Error budgets between the exercise engine and the kernel, and as reports and recordings' readers have them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/result.hpp"
#include "flow/scene.hpp"

namespace rhexis {

/// The quantities of the kernel: list of {"name", "unit", "from", "to", "meaning", "kept"}; kept: what is kept where
/// nothing is said, as a text.
nlohmann::json quantities_json();

/// {"step_s", "step_by_hand", "time_s", "models": [{"model", "way", "mesh", "budget", "expected", "cost", "by_hand",
/// "instead", "machine"}], "cost"}.
nlohmann::json accuracy_json(const SceneAccuracy& accuracy);

/// Makes a scene as fine as its exercise wants it: given is what the engine's host.scene gave. By the tables in
/// root/assets/accuracy, or as was chosen for the scene that it continues.
Status choose_accuracy_of(const nlohmann::json& given, const std::string& root, SceneDescription& scene);

}  // namespace rhexis
