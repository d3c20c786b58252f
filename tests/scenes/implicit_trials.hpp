// SPDX-License-Identifier: GPL-3.0-or-later
// Provocations of the implicit way to advance a solid, short as tests and long as benchmarks. Each returns what it
// measured; the gates stand where it is called.
#pragma once

#include "scenes/explicit_trials.hpp"

namespace rhexis::scenes {

/// T1: a body released from a bad start, for `seconds`, in steps of dt [s].
Recovery recover_implicit(SolidModel model, BadStart start, double seconds, double dt);

enum class Contortion { bent, twisted };

struct Untangling {
    int iterations = 0;           ///< Newton iterations of the step
    double worst_ratio = 0.0;     ///< largest residual of an iteration over that of the one before
    double residual = 0.0;        ///< at the end, relative
    double inverted_start = 0.0;  ///< share of the elements
    double inverted_end = 0.0;
};
/// T2: a bar of 4 x 1 x 1 mm, `across` cells thick, is held at both ends and there turned by 180 degrees about its axis
/// or bent onto itself; then one backward Euler step of `dt` [s] to a relative residual of 1e-8. smooth: the bar
/// between follows evenly at the start; otherwise it is still straight, and all the turn is in the elements at its end.
Untangling untangle(Contortion contortion, bool smooth, int across, double dt);

struct Sag {
    double ratio = 0.0;      ///< tip deflection over that of quadratic tetrahedra (C3D10)
    int linear = 0;          ///< most iterations of a linear solve to 1e-9
    double residual = 0.0;   ///< largest relative residual left
    bool converged = false;  ///< all steps
};
/// T3: the bar of the bending table (4 x 1 x 1 mm, E 3000 Pa, weight 1 uN/mm^3) falls into its equilibrium in 10 ms
/// steps of one linearised solve. reference [mm]: of C3D10; `sliver`: T4, volume of one flattened element over what it
/// was (1: none).
Sag sag(int across, double poisson_ratio, double reference, double sliver);

struct Staleness {
    double fresh = 0.0;       ///< linear iterations a step with a new factor each step
    double stale = 0.0;       ///< the same with a factor as old as the run
    double difference = 0.0;  ///< largest distance between their ends [mm]
    double moved = 0.0;       ///< how far the body went meanwhile [mm]
};
/// T16: the same falling bar with both, over so many 10 ms steps.
Staleness grow_stale(int steps);

struct QuietEnd {
    int steps = 0;
    bool finite = false;
    bool converged = false;   ///< every step
    double mass_error = 0.0;  ///< of removed + left against the start, relative
    double fastest = 0.0;     ///< [mm/s] at any time
    double rest_speed = 0.0;  ///< [mm/s] of any node once nothing is left
};
/// T17: removes `per_step` tetrahedra at random before each 10 ms step until none is left.
QuietEnd remove_all(const SolidModel& model, int per_step);

struct Drift {
    double linear = 0.0;   ///< momentum per step, over the sum of m |v|
    double angular = 0.0;  ///< angular momentum per step, over the sum of m |r| |v|, beyond the method's own
    double rise = 0.0;     ///< largest rise of elastic + kinetic energy in a step, over that at the start
    double left = 0.0;     ///< energy of the end over that of the start
};
/// T20, T21: a stretched, spinning, flying body without damping, so many steps of dt [s], solved to a relative residual
/// of 1e-13. Exact backward Euler keeps momentum, and changes angular momentum by dt sum m v' x v in a step (v' after,
/// v before it), whatever the forces: that is taken off.
Drift drift(SolidModel model, int steps, double dt);

}  // namespace rhexis::scenes
