// SPDX-License-Identifier: GPL-3.0-or-later
// A scene's description is checked field by field before anything is built from it.
#pragma once

#include "base/result.hpp"
#include "flow/scene.hpp"

namespace rhexis {

/// The first field that is wrong, with its value and what is allowed.
Status check_scene(const SceneDescription& scene);

}  // namespace rhexis
