// SPDX-License-Identifier: GPL-3.0-or-later
// Gates of the models without meshes, at the longest step.
#include <algorithm>
#include <cmath>

#include "scenes/lumped_trials.hpp"
#include "scenes/stability_gates.hpp"

namespace rhexis::scenes {

Gates gates_of_lumped_models(bool quick) {
    constexpr double mmhg = 133.322;  // [Pa]
    const int draws = quick ? 2 : 6;
    Gates gates;
    for (const LumpedScene& scene : lumped_scenes()) {
        Extremes worst;
        for (int seed = 1; seed <= draws; ++seed) {
            const Extremes found = run_extremes(scene, static_cast<std::uint64_t>(seed), quick ? 1.0 : 3.0);
            worst.finite = worst.finite && found.finite;
            worst.lowest = std::min(worst.lowest, found.lowest);
            worst.pressure = std::max(worst.pressure, found.pressure);
            worst.chatter = std::max(worst.chatter, found.chatter);
            worst.apart = std::max(worst.apart, found.apart);
            worst.failures += found.failures;
        }
        const std::string id = std::string("T27 ") + scene.name;
        gates.push_back(
            {id, "lowest volume of anything, below nothing [mm^3]", worst.finite ? -worst.lowest : NAN, 1e-9});
        gates.push_back({id, "most pressure of the eye [mmHg]", worst.pressure / mmhg, 700.0});
        gates.push_back({id, "samples at which a pressure turns that nothing turns, share", worst.chatter, 0.05});
        gates.push_back(
            {id, "pressure at 20 ms against that at 1 ms, rms, of its range", worst.apart, scene.bursts ? 0.3 : 0.05});
        gates.push_back({id, "steps that no way could solve", static_cast<double>(worst.failures), 0.0});
    }
    return gates;
}

}  // namespace rhexis::scenes
