// SPDX-License-Identifier: GPL-3.0-or-later
// Gates of a lens in pieces: how they meet, how it cracks, how suction holds it.
#include <cmath>

#include "scenes/piece_trials.hpp"
#include "scenes/stability_gates.hpp"

namespace rhexis::scenes {
namespace {

constexpr const char* unsolved = "steps that no way could solve";

double whole(int count) { return static_cast<double>(count); }

}  // namespace

Gates gates_of_pieces(bool quick) {
    Gates gates;
    for (const int speed : {5, 20, 100, 1000}) {
        const Collision found = collide(speed);
        const std::string id = "T23 halves at " + std::to_string(speed) + " mm/s";
        gates.push_back({id, "momentum changed, relative", found.momentum, 1e-6});
        gates.push_back({id, "energy beyond that at the start, relative", found.gain, 1e-3});
        gates.push_back({id, "one is behind the other at the end (1: yes)", found.parted ? 0.0 : 1.0, 0.0});
        gates.push_back({id, unsolved, whole(found.failures), 0.0});
    }
    const Crowd crowd = press_segments(quick ? 1000 : 3000, quick ? 0.5 : 2.0);
    const std::string id = "T23 eight segments";
    gates.push_back({id, "deepest that one lies in another [mm]", crowd.overlap, 0.35});
    gates.push_back({id, "fastest node [mm/s]", crowd.fastest, 400.0});
    gates.push_back({id, "kinetic energy after the tool has gone [nJ]", crowd.left, 30.0});
    gates.push_back({id, "tetrahedra left inverted", whole(crowd.inverted), 0.0});
    gates.push_back({id, unsolved, whole(crowd.failures), 0.0});
    return gates;
}

Gates gates_of_cracks(bool quick) {
    Gates gates;
    const int cells = quick ? 2 : 3;
    for (const int at_once : {4, 20}) {
        const Breaking found = break_all(cells, at_once);
        const std::string id = "T24 " + std::to_string(at_once) + " faces at once";
        gates.push_back({id, "tetrahedra that are no piece of their own at the end",
                         found.fault.empty() ? whole(5 * cells * cells * cells - found.pieces) : NAN, 0.0});
        gates.push_back({id, "mass left against the start, relative", found.mass_off, 1e-12});
        gates.push_back({id, "kinetic energy of crumbs that lay still when they broke [nJ]", found.kinetic, 3.0});
        gates.push_back({id, "fastest node [mm/s]", found.fastest, 200.0});
        gates.push_back({id, "stable step of the whole over the smallest on the way", 1.0 / found.step, 1.7});
        gates.push_back({id, unsolved, whole(found.failures), 0.0});
    }
    const Running run = run_crack(quick ? 0.5 : 0.25);
    const std::string id = "T24 crack that runs";
    gates.push_back({id, "what it leaves whole before the end, in cells", run.left, 2.0});
    gates.push_back({id, "faces that break in a step", whole(run.most_at_once), 8.0});
    gates.push_back({id, "farthest broken face from its plane, in cells", run.aside, 4.0});
    gates.push_back({id, "largest rise of the energy in a step, relative", run.rise, 1e-3});
    gates.push_back({id, unsolved, whole(run.failures), 0.0});
    return gates;
}

Gates gates_of_suction(bool) {
    Gates gates;
    for (const auto& [suction, name] : {std::pair{Suction::ample, "ample"}, std::pair{Suction::threshold, "slips"},
                                        std::pair{Suction::on_and_off, "on and off"}}) {
        const Grip found = draw_up(suction);
        const std::string id = std::string("T25 ") + name;
        gates.push_back({id, "force on the tip over what suction holds", found.most, 1.3});
        gates.push_back(
            {id, "energy beyond the work of the tip, over what suction does in a tenth of a mm", found.gain, 1.5});
        if (suction == Suction::ample) {
            gates.push_back({id, "way of the tip against that of the cube, relative", std::abs(found.led - 1.0), 0.5});
        }
        gates.push_back({id, "energy left half a second after it is let go, over the largest", found.left, 1e-3});
        gates.push_back({id, unsolved, whole(found.failures), 0.0});
    }
    return gates;
}

}  // namespace rhexis::scenes
