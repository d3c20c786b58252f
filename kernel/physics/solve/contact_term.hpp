// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a contact as the solvers see it, linearised about the current iterate.
#pragma once

#include <array>
#include <vector>

#include "math/types.hpp"

namespace rhexis {

/// What a node's displacement, or a shell's turn, adds to the relative displacement of a contact: share du(node).
struct ContactShare {
    int node = 0;
    Mat3 share = Mat3::Identity();
};

/// One surface point of a body against a rigid partner, or against another part of itself. Relative displacement
///   u = sum_k weights[k] du(nodes[k]) + sum_more share du(node) - (db + dtheta x arm)
/// (the bracket only if body >= 0)
/// changes the force on the solid by -stiffness u; the body gets the opposite force at `arm` from its centre.
struct ContactTerm {
    std::array<int, 3> nodes{0, -1, -1};  ///< coarse nodes; -1: unused
    std::array<double, 3> weights{1.0, 0.0, 0.0};
    std::vector<ContactShare> more;  ///< turns of a shell, its other side
    int body = -1;                   ///< moving rigid partner (bag index), or -1: kinematic
    Vec3 arm = Vec3::Zero();         ///< [mm]
    Vec3 force = Vec3::Zero();       ///< on the solid at the current iterate [uN]
    Mat3 stiffness = Mat3::Zero();   ///< symmetric positive semidefinite [uN/mm]
};

}  // namespace rhexis
