// SPDX-License-Identifier: GPL-3.0-or-later
// Provocations of contact and friction, short as tests and long as benchmarks. Each returns what it measured; the gates
// stand where it is called.
#pragma once

#include "flow/solid.hpp"

namespace rhexis::scenes {

struct Slide {
    double drift = 0.0;     ///< way of the centre along the plane in the time watched [mm]
    double aside = 0.0;     ///< of it, across the slope [mm]
    double expected = 0.0;  ///< way of a rigid block that starts from rest and slides [mm]; 0: it sticks
    int rollbacks = 0;
    int failures = 0;  ///< steps that no way could solve
};
/// T14: a cube of 1 mm on a plane with friction 0.3, tilted by atan(0.3) times `share` towards `heading` [rad], put
/// down and, from 0.3 s on, watched for `seconds`. A share below 1 must stick, above 1 must slide.
Slide slide(double share, double heading, Advance advance, double seconds);

struct Strike {
    double penetration = 0.0;  ///< deepest after any step, over the mean edge of the mesh
    double fastest = 0.0;      ///< node after any step, over the speed of the tool
    double gain = 0.0;         ///< largest excess of the energy over the work done so far, over the largest work
    double work = 0.0;         ///< largest work of the tool so far [nJ]
    double left = 0.0;         ///< energy 0.5 s after the tool has gone, over the largest work
    int inverted = 0;          ///< tetrahedra 0.5 s after the tool has gone
    int failures = 0;          ///< steps that no way could solve
    int most_substeps = 0;     ///< of a step
};
enum class Blow { down, across };
/// T11: a probe of 0.5 mm at 1 m/s in steps of 10 ms, 1 cm a step: down onto a block of 4 x 4 x 2 mm, 0.4 mm deep in
/// one step and out in the next, three times; or to and fro across it, 0.2 mm under its surface.
Strike strike(Blow blow, Advance advance);

struct Press {
    double force = 0.0;  ///< on the tool, mean of the last quarter [uN]
    double dip = 0.0;    ///< of the surface under the tool, at the end [mm]
    int rollbacks = 0;
};
/// A ball of 1 mm pressed 0.15 mm into a block of 4 x 4 x 2 mm held at the bottom, within 0.1 s, and held for 0.1 s, in
/// steps of dt [s].
Press press(Advance advance, double dt);

}  // namespace rhexis::scenes
