// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a contact as the solvers see it, linearised about the current iterate.
#pragma once

#include <array>

#include "math/types.hpp"

namespace rhexis {

/// One surface point of a solid against a rigid partner. Relative displacement
///   u = sum_k weights[k] du(nodes[k]) - (db + dtheta x arm)        (the bracket only if body >= 0)
/// changes the force on the solid by -stiffness u; the body gets the opposite force at `arm` from its centre.
struct ContactTerm {
    std::array<int, 3> nodes{0, -1, -1};  ///< coarse nodes; -1: unused
    std::array<double, 3> weights{1.0, 0.0, 0.0};
    int body = -1;                  ///< moving rigid partner (bag index), or -1: kinematic
    Vec3 arm = Vec3::Zero();        ///< [mm]
    Vec3 force = Vec3::Zero();      ///< on the solid at the current iterate [uN]
    Mat3 stiffness = Mat3::Zero();  ///< symmetric positive semidefinite [uN/mm]
};

}  // namespace rhexis
