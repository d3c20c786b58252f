// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets in states in which they run away where something is wrong with them.
#pragma once

#include "energy/orthotropic.hpp"

namespace rhexis::scenes {

/// A square stretched by 10 % and held all round, its other nodes out of its plane at random by up to 0.01 mm.
struct Tautness {
    double swing = 0.0;  ///< largest distance from the plane over that at the start; not a number: a step failed
};
Tautness shake_taut(double dt, int steps);

/// A square with fibres pushed together to 0.4 of its length and crumpled at random, held at one edge; steps of 10 ms.
struct Slackness {
    double residual =
        0.0;             ///< relative, largest that a linear solve left: conjugate gradients stop at negative curvature
    double rise = 0.0;   ///< largest of the energy in a step, share of that at the start
    double left = 0.0;   ///< of the energy, likewise
    double least = 0.0;  ///< eigenvalue of any triangle's stiffness on the way, over its norm
};
Slackness crumple(int steps);

/// Fibres at every degree from 0 to 180.
struct FibreSweep {
    double condition =
        0.0;              ///< largest eigenvalue of the material's stiffness over its smallest; not a number: none > 0
    double spread = 0.0;  ///< of the eigenvalues of that stiffness over the angles, relative: none, but for rounding
    double least = 0.0;   ///< eigenvalue of a triangle's stiffness in any of 20 random states, over its norm
};
FibreSweep sweep_fibres(const Orthotropic& material);

/// A sheet with fibres in a random state: change of its energy, relative.
struct Renumbering {
    double renumbered = 0.0;  ///< triangles in reverse order, each begun at its next corner
    double turned = 0.0;      ///< all of it, at rest and now, about a slanting axis
};
Renumbering renumber();

}  // namespace rhexis::scenes
