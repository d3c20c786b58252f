// SPDX-License-Identifier: GPL-3.0-or-later
// Tissues that an exercise names for nothing.
#pragma once

#include <string>
#include <vector>

#include "flow/scene.hpp"

namespace rhexis {

/// Tissues of a scene that no step, event or score uses, no other tissue or instrument needs, and that do not show in a
/// picture by themselves. used: measures that the exercise uses. A tissue is used where a measure is that the scene
/// lacks without it.
std::vector<std::string> unused_tissues(const SceneDescription& scene, const std::vector<std::string>& used);

}  // namespace rhexis
