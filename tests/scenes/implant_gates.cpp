// SPDX-License-Identifier: GPL-3.0-or-later
// Gates of an implant in its bag.
#include <cmath>

#include "scenes/implant_trials.hpp"
#include "scenes/stability_gates.hpp"

namespace rhexis::scenes {
namespace {

void add_settling(Gates& gates, const std::string& id, const Settling& found) {
    gates.push_back({id, "deepest penetration over thickness", found.finite ? found.deepest : NAN, 0.06});
    gates.push_back({id, "largest residual of a step, over the forces of contact", found.residual, 0.01});
    gates.push_back({id, "steps that are kept without being balanced, share", found.rough, 0.01});
    gates.push_back({id, "steps that no way could solve", static_cast<double>(found.failures), 0.0});
}

}  // namespace

Gates gates_of_implants(bool quick) {
    Gates gates;
    const double seconds = quick ? 0.2 : 6.0;  // after the end of the stroke
    const Settling coarse = settle_in_bag(0.02, seconds);
    add_settling(gates, "T26 20 ms", coarse);
    if (quick) {
        return gates;
    }
    const Settling fine = settle_in_bag(0.01, seconds);
    add_settling(gates, "T26 10 ms", fine);
    gates.push_back({"T26 20 ms", "fastest node at the end [mm/s]", coarse.speed, 2.0});
    gates.push_back({"T26 10 ms", "fastest node at the end [mm/s]", fine.speed, 2.0});
    gates.push_back(
        {"T26 20 ms", "where it ends from where it does at 10 ms [mm]", (coarse.middle - fine.middle).norm(), 0.7});
    return gates;
}

}  // namespace rhexis::scenes
