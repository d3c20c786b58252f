// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid ball pressed without friction into a body as large as can be: the contact problem that has a closed form.
#pragma once

#include "flow/solid.hpp"

namespace rhexis::scenes {

struct HertzCase {
    double young_modulus = 5000.0;  ///< [Pa]
    double poisson_ratio = 0.3;
    double radius = 2.0;  ///< of the ball [mm]
    double depth = 0.02;  ///< of its lowest point under the undeformed surface [mm]

    /// Force on the ball [uN]: 4/3 E / (1 - nu^2) sqrt(R) d^1.5 [Johnson1985, 4.24].
    [[nodiscard]] double force() const;
    /// Radius of the patch that touches [mm]: sqrt(R d).
    [[nodiscard]] double patch() const;
};

struct HertzResult {
    int tetrahedra = 0;
    double force = 0.0;     ///< on the ball [uN]
    double sideways = 0.0;  ///< of it, across its axis [uN]
    double patch = 0.0;     ///< farthest vertex in contact from the axis [mm]
    double spacing = 0.0;   ///< of vertices there [mm]
    double change = 0.0;    ///< of the force in the last step, relative: how far from rest
    int rollbacks = 0;
};

/// Presses a ball into a block of 2 n x 2 n x n cells, finer towards the middle and 8 patch radii deep and half as
/// wide. The block stands for a half-space: its sides and its bottom are held where a point force equal to the closed
/// form displaces a half-space [Johnson1985, 3.18 and 3.19]. So far away that is the displacement under the ball as
/// well, but for a share of about (patch / distance)^2, and the force would follow an error there by an eighth at most.
HertzResult press_ball(const HertzCase& problem, int n, Formulation formulation);

}  // namespace rhexis::scenes
