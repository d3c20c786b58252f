// SPDX-License-Identifier: GPL-3.0-or-later
// Gates of thin shells: by load, and by what squeezes and bends them.
#include <cmath>

#include "scenes/shell_trials.hpp"
#include "scenes/squeeze_trials.hpp"
#include "scenes/stability_gates.hpp"

namespace rhexis::scenes {
namespace {

std::string in_milliseconds(double dt) { return std::to_string(std::lround(1e3 * dt)) + " ms"; }

double number(int count) { return static_cast<double>(count); }

void add_cylinders(Gates& gates, CylinderWay way, const std::string& name, double dt, bool quick) {
    const CylinderRuns found = pull_cylinders(way, dt, quick);
    const std::string id = "T10 cylinder " + name + " " + in_milliseconds(dt);
    const std::string of = " of " + std::to_string(found.runs);
    gates.push_back({id, "runs that end elsewhere without a flag on any step," + of, number(found.hidden), 0.0});
    if (way == CylinderWay::predicted_stress) {
        gates.push_back({id, "runs that end elsewhere than statics, all of them flagged," + of, number(found.elsewhere),
                         0.4 * found.runs});
        return;
    }
    gates.push_back({id, "runs that end elsewhere than statics," + of, number(found.elsewhere), 0.0});
    gates.push_back({id, "steps that do not balance", number(found.flagged), 0.0});
}

void add_squeeze(Gates& gates, const std::string& id, const Squeeze& found, double jitter, double deepest) {
    gates.push_back({id, "change of a jaw's force from step to step while all stands still, rms over its mean",
                     found.jitter, jitter});
    gates.push_back({id, "difference of the jaws' forces over one of them", found.uneven, 1e-3});
    gates.push_back({id, "deepest penetration over thickness, or the edge of the mesh", found.deepest, deepest});
    gates.push_back({id, "energy beyond the work done, over that work", found.gain, 1e-3});
    gates.push_back({id, "steps that no way could solve", number(found.failures), 0.0});
}

}  // namespace

Gates gates_of_flat_shells(bool) {
    Gates gates;
    const FlatStart ring = load_flat_ring();
    gates.push_back({"T9 ring", "Newton iterations for the whole load at once", number(ring.iterations), 200.0});
    gates.push_back({"T9 ring", "loads without an equilibrium", number(ring.unbalanced), 0.0});
    gates.push_back({"T9 ring", "distance from the end of eight smaller loads, relative", ring.apart, 1e-5});
    for (const double dt : {1e-2, 2e-2}) {
        const FlatStart strip = load_flat_strip(dt);
        const std::string id = "T9 strip " + in_milliseconds(dt);
        gates.push_back({id, "Newton iterations of the first step", number(strip.iterations), 30.0});
        gates.push_back({id, "steps that do not balance", number(strip.unbalanced), 0.0});
        gates.push_back({id, "distance from the elastica, relative", strip.apart, 0.003});
    }
    return gates;
}

Gates gates_of_snaps(bool quick) {
    Gates gates;
    const SnapPath path = follow_roof(quick ? 8 : 12);
    gates.push_back({"T10 roof", "load of the first limit point against 0.742, relative",
                     path.passed ? std::abs(path.upper / 0.742 - 1.0) : NAN, 0.03});
    gates.push_back({"T10 roof", "load of the second against 0.173, relative",
                     path.passed ? std::abs(path.lower / 0.173 - 1.0) : NAN, 0.05});
    const SnapThrough roof = snap_roof();
    gates.push_back(
        {"T10 roof stepped", "distance from rest beyond the jump, relative", std::abs(roof.beyond - 1.0), 1e-3});
    gates.push_back({"T10 roof stepped", "speed left over the fastest", roof.speed, 1e-3});
    gates.push_back({"T10 roof stepped", "steps that do not balance", number(roof.unbalanced), 0.0});
    for (const double dt : {1e-2, 2e-2}) {
        add_cylinders(gates, CylinderWay::world, "in the world", dt, quick);
        add_cylinders(gates, CylinderWay::predicted_stress, "predicted stress, kept", dt, quick);
        add_cylinders(gates, CylinderWay::true_stress, "true stress, kept", dt, quick);
    }
    return gates;
}

Gates gates_of_jaws(bool quick) {
    Gates gates;
    add_squeeze(gates, "T12 shell", squeeze_strip(), 1e-6, 0.05);
    for (const Advance way : {Advance::explicit_, Advance::implicit}) {
        const std::string name = way == Advance::explicit_ ? "explicit" : "implicit";
        add_squeeze(gates, "T12 solid " + name, squeeze_cube(way, 0.3, quick), 1e-3, 0.05);
        add_squeeze(gates, "T12 solid crushed " + name, squeeze_cube(way, 0.8, quick), 1e-2, 0.1);
    }
    return gates;
}

Gates gates_of_stacks(bool) {
    Gates gates;
    for (const bool heavy : {false, true}) {
        const Stack found = stack_plates(heavy);
        const std::string id = heavy ? "T13 mass 1000 : 1" : "T13 stack of five";
        gates.push_back({id, "deepest penetration over thickness", found.deepest, 0.05});
        gates.push_back({id, "drift of any node [mm/s]", found.drift, 1e-4});
        gates.push_back({id, "what the ground bears against the weight, relative", std::abs(found.borne - 1.0), 1e-3});
        gates.push_back({id, "energy of a step beyond what was brought, over all that was", found.gain, 1e-6});
        gates.push_back({id, "steps that do not balance", number(found.unbalanced), 0.0});
    }
    return gates;
}

Gates gates_of_turned_contact(bool quick) {
    Gates gates;
    for (const auto& [lift, tilt] : {std::pair{0.1, 0.05}, std::pair{1.0, 0.3}, std::pair{3.0, 0.7}}) {
        if (quick && tilt == 0.3) {
            continue;
        }
        const LiftedForce found = lift_strip(lift, tilt);
        const std::string id = "T15 lifted by " + std::to_string(lift).substr(0, 3) + " mm";
        gates.push_back({id, "force of the plane against the elastica, relative", found.error, 0.01});
        gates.push_back({id, "deepest penetration over thickness", found.deepest, 0.05});
        gates.push_back({id, "steps that do not balance", number(found.unbalanced), 0.0});
    }
    const CutPress cut = cut_under_tool(quick ? 20 : 60);
    gates.push_back(
        {"T15 cut", "distance from the same steps with new factors, over the way of the body", cut.apart, 5e-3});
    gates.push_back({"T15 cut", "deepest penetration over the edge of the mesh", cut.deepest, 0.1});
    gates.push_back({"T15 cut", "steps that no way could solve", number(cut.failures), 0.0});
    return gates;
}

}  // namespace rhexis::scenes
