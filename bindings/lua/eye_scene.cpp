// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/eye_scene.hpp"

namespace rhexis::lua {

EyeScene::EyeScene(Session session) : session_(std::move(session)) { note_elements(); }

Result<StepOutcome> EyeScene::advance(std::span<const DeviceSample> samples) {
    StepOutcome outcome = session_.step(samples, commands_);
    commands_.clear();
    return outcome;
}

}  // namespace rhexis::lua
