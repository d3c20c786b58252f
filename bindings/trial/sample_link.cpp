// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/sample_link.hpp"

namespace rhexis {

Status LinkedOperator::begin(Timeline& timeline) {
    const SceneDescription& scene = timeline.scene();
    hands_.resize(scene.instruments.size());
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        hands_[i].instrument = static_cast<int>(i);
    }
    if (const Status begun = link_.begin(scene.instruments, scene.step_s); !begun) {
        return begun;
    }
    return inner_.begin(timeline);
}

Result<OperatorStep> LinkedOperator::operate(Timeline& timeline) {
    Result<OperatorStep> step = inner_.operate(timeline);
    if (!step || step.value().done) {
        return step;
    }
    for (const DeviceSample& sample : step.value().samples) {
        if (sample.instrument >= 0 && static_cast<std::size_t>(sample.instrument) < hands_.size()) {
            hands_[static_cast<std::size_t>(sample.instrument)] = sample;
        }
    }
    Result<std::vector<DeviceSample>> seen = link_.through(hands_);
    if (!seen) {
        return seen.error();
    }
    step.value().samples = std::move(seen).value();
    return step;
}

}  // namespace rhexis
