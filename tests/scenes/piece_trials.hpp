// SPDX-License-Identifier: GPL-3.0-or-later
// Provocations of a solid in pieces: how they meet, how they come about, and how suction holds one. Each returns what
// it measured; the gates stand where it is called.
#pragma once

#include <string>

namespace rhexis::scenes {

struct Collision {
    double momentum = 0.0;  ///< changed over the run, over the sum of m |v| at the start
    double gain = 0.0;      ///< largest energy beyond that at the start, over it
    double overlap = 0.0;   ///< deepest that one middle has come to the other beyond touching, over the width
    bool parted = false;    ///< at the end they fly apart, each on its side
    int failures = 0;       ///< steps that no way could solve
};
/// T23: the two halves of a cut block, 1 mm wide each, fly at each other in steps of 10 ms, weightless, without
/// damping.
Collision collide(double speed);

struct Crowd {
    double overlap = 0.0;  ///< deepest that a node of one piece lies in a tetrahedron of another [mm]
    double left = 0.0;     ///< largest kinetic energy later than a fifth of a second after the tool has gone [nJ]
    double fastest = 0.0;  ///< node [mm/s]
    int inverted = 0;      ///< tetrahedra at the end
    int failures = 0;      ///< steps that no way could solve
};
/// T23: the default patient's lens in its bag, cut into eight segments; a probe presses 0.3 mm deep on its middle and
/// goes; looked at for so many seconds more.
Crowd press_segments(int tetrahedra, double seconds);

struct Breaking {
    int pieces = 0;         ///< at the end
    double mass_off = 0.0;  ///< what is left against the start, relative
    double fastest = 0.0;   ///< [mm/s] of any node at any time
    double kinetic = 0.0;   ///< largest, half a second after the last break included [nJ]
    double step = 0.0;      ///< least stable step met on the way over that of the whole
    int failures = 0;       ///< steps that no way could solve
    std::string fault;      ///< of the mesh after a break; empty: none
};
/// T24: a cube of `cells`^3 cells at rest, weightless, in which faces break at random, `at_once` before each step of
/// 10 ms, until every tetrahedron is a piece of its own.
Breaking break_all(int cells, int at_once);

struct Running {
    int steps = 0;         ///< until the strip is in two
    int most_at_once = 0;  ///< faces in a step
    double aside = 0.0;    ///< farthest broken face from the middle plane, over the cell
    double rise = 0.0;     ///< largest rise of elastic and kinetic energy in a step, over that at the start
    double left = 0.0;     ///< of the strip's end when nothing breaks any more, over the cell
    int failures = 0;
};
/// T24: a stretched strip with a crack half way along its middle, which runs by itself to the end.
Running run_crack(double cell);

struct Grip {
    double most = 0.0;  ///< largest force of the grip over what suction holds
    double gain = 0.0;  ///< energy beyond the work of the tip, over that work
    double led = 0.0;   ///< way of what is held over that of the tip
    double left = 0.0;  ///< energy half a second after suction has gone, over the largest before
    int failures = 0;
};
/// How suction is asked for while the tip pulls.
enum class Suction {
    ample,       ///< far more than is needed
    threshold,   ///< what is needed is reached on the way: it slips
    on_and_off,  ///< ample in every other step
};
/// T25: a cube on the ground, held by its underside; a tip draws its top up by 0.4 mm at 2 mm/s, then suction goes.
Grip draw_up(Suction suction);

}  // namespace rhexis::scenes
