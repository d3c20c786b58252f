// SPDX-License-Identifier: GPL-3.0-or-later
// Gates of what touches tools, planes and bags, and of what feeds it.
#include <cmath>
#include <numbers>

#include "scenes/contact_trials.hpp"
#include "scenes/session_trials.hpp"
#include "scenes/stability_gates.hpp"

namespace rhexis::scenes {
namespace {

constexpr Advance ways[] = {Advance::explicit_, Advance::implicit};

std::string name_of(Advance way) { return way == Advance::explicit_ ? "explicit" : "implicit"; }

void add_strike(Gates& gates, const std::string& id, const Strike& found, double deepest) {
    gates.push_back({id, "deepest penetration over the edge of the mesh", found.penetration, deepest});
    gates.push_back({id, "energy beyond the work done, over that work", found.gain, 1e-3});
    gates.push_back({id, "fastest node over the speed of the tool", found.fastest, 2.0});
    gates.push_back({id, "energy left half a second later, over the work", found.left, 1e-3});
    gates.push_back({id, "tetrahedra left inverted", static_cast<double>(found.inverted), 0.0});
    gates.push_back({id, "steps that no way could solve", static_cast<double>(found.failures), 0.0});
}

}  // namespace

Gates gates_of_strikes(bool) {
    Gates gates;
    for (const Advance way : ways) {
        // struck from above, the springs that stand for contact in the implicit way give more: see docs/stability.md
        add_strike(gates, "T11 down " + name_of(way), strike(Blow::down, way), 0.05);
        add_strike(gates, "T11 across " + name_of(way), strike(Blow::across, way), 0.05);
    }
    return gates;
}

Gates gates_of_inclines(bool quick) {
    Gates gates;
    for (const Advance way : ways) {
        for (const int degrees : {0, 30, 45}) {
            const double heading = degrees * std::numbers::pi / 180.0;
            const std::string id =
                std::string("T14 ").append(name_of(way)).append(" towards ").append(std::to_string(degrees));
            const double seconds = quick ? 2.0 : 10.0;
            const Slide sticks = slide(0.99, heading, way, seconds);
            gates.push_back({id + " below", std::string("drift in ").append(std::to_string(seconds)) + " s [mm]",
                             sticks.failures == 0 ? sticks.drift : NAN, 1e-6});
            const Slide slides = slide(1.01, heading, way, 0.5);
            gates.push_back({id + " above", "way against that of a rigid block, relative",
                             slides.failures == 0 ? std::abs(slides.drift / slides.expected - 1.0) : NAN, 0.15});
            gates.push_back({id + " above", "way across the slope, share", slides.aside / slides.drift, 1e-3});
        }
    }
    return gates;
}

Gates gates_of_input(bool) {
    Gates gates;
    for (const Advance way : ways) {
        const Disturbed calm = disturb(Disturbance::none, way);
        // an explicit step costs the same whatever the hand does; an implicit one is cut for a fast tool, whose speed
        // is bounded
        const double cap = way == Advance::explicit_ ? calm.most_substeps : 200.0;
        for (const auto& [disturbance, name] :
             {std::pair{Disturbance::missing, "samples lost "}, std::pair{Disturbance::spike, "spike "},
              std::pair{Disturbance::pause, "pause "}}) {
            const Disturbed found = disturb(disturbance, way);
            const std::string id = std::string("T22 ").append(name).append(name_of(way));
            gates.push_back(
                {id, "steps executed beyond those asked for", static_cast<double>(found.steps - found.calls), 0.0});
            gates.push_back({id, "substeps of a step", static_cast<double>(found.most_substeps), cap});
            gates.push_back({id, "steps that no way could solve", static_cast<double>(found.failures), 0.0});
            gates.push_back(
                {id, "largest shift of the lens in a step over that with an even hand", found.jump / calm.jump, 5.0});
            gates.push_back({id, "distance of the lens from where an even hand leaves it [mm]",
                             (found.shift - calm.shift).norm(), 0.1});
        }
    }
    return gates;
}

}  // namespace rhexis::scenes
