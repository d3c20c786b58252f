// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/implant_trials.hpp"

#include <algorithm>

#include "scenes/bag_injection.hpp"

namespace rhexis::scenes {

Settling settle_in_bag(double dt, double seconds) {
    constexpr double balanced = 1e-3;  // as the world asks of a step in contact
    BagInjection scene({.bag = 400.0, .implant = 400.0, .dt = dt, .unfolding = seconds});
    Settling found;
    for (int i = 0; i < scene.steps(); ++i) {
        const StepOutcome outcome = scene.step();
        const ShellStepReport& report = outcome.shells[0];
        found.failures += outcome.failure == StepFailure::none ? 0 : 1;
        found.deepest = std::max(found.deepest, report.deepest);
        found.residual = std::max(found.residual, report.residual);
        found.rough += report.residual > balanced ? 1.0 / scene.steps() : 0.0;
    }
    const ShellState& implant = scene.state.shells[0];
    for (std::size_t n = 0; n < implant.position.size(); ++n) {
        found.middle += implant.position[n] / static_cast<double>(implant.position.size());
        found.speed = std::max(found.speed, implant.velocity[n].norm());
        found.finite = found.finite && implant.position[n].allFinite();
    }
    return found;
}

}  // namespace rhexis::scenes
