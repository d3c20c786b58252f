// SPDX-License-Identifier: GPL-3.0-or-later
// Provocations of the explicit way to advance a solid, short as tests and long as benchmarks. Each returns what it
// measured; the gates stand where it is called.
#pragma once

#include <vector>

#include "flow/solid.hpp"
#include "physics/solid/explicit_solid.hpp"
#include "scenes/measures.hpp"

namespace rhexis::scenes {

/// Elastic plus kinetic energy in double [nJ], with the inertia that the solid is stepped with.
double total_energy(const SolidModel& model, const SolidState& state, const ExplicitSolid& solid);

struct Recovery {
    double inverted_at_start = 0.0;  ///< share of the elements
    double inverted_at_end = 0.0;
    double largest_rise = 0.0;  ///< of the total energy between samples, over the energy at the start
    double energy_left = 0.0;   ///< over the energy at the start
    bool finite = false;
};
/// T1: every node at a random place of the body's box, or all on one plane, or mirrored, then released for `seconds`.
Recovery recover(SolidModel model, BadStart start, double seconds);

struct Deletion {
    int steps = 0;
    bool finite = false;
    double fastest = 0.0;        ///< [mm/s] at any time
    double smallest_step = 0.0;  ///< least stable step met on the way, over that of the whole body
    double mass_error = 0.0;     ///< of removed + left against the start, relative
};
/// T17: removes `per_round` tetrahedra at random every `round` steps until none is left, at 0.8 of each stable step.
Deletion delete_all(SolidModel model, int per_round, int round);

struct Flight {
    double linear_drift = 0.0;   ///< per step, of the momentum over sum of m |v|
    double angular_drift = 0.0;  ///< per step, over sum of m |r| |v|
    double energy_drift = 0.0;   ///< mean energy of the last tenth against the first tenth, relative
    double temperature = 0.0;    ///< kinetic energy relative to the centre, last tenth against first tenth, relative
};
/// T20, T21: a stretched, spinning, flying body without damping, at `share` of the stable step.
Flight fly(SolidModel model, int steps, double share);

/// T21: the same flight by the same method in double precision: what is left is the method's own [as energy_drift].
double drift_in_double(SolidModel model, int steps, double share);

struct Limit {
    double step = 0.0;    ///< stable step that the solid gives [s]
    double exact = 0.0;   ///< that of the same stiffness and masses in double precision [s]
    bool below = false;   ///< stays bounded at 0.97 of what it gives
    bool beyond = false;  ///< blows up at 1.1 of the exact one
};
/// T3, T4: is the limit that the solid states the true one?
Limit probe_limit(const SolidModel& model);

/// Presses one node into the opposite faces of its tetrahedra until the thinnest has `share` of its volume: a sliver.
void flatten_one(SolidModel& model, double share);

}  // namespace rhexis::scenes
