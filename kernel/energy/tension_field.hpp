// SPDX-License-Identifier: GPL-3.0-or-later
// What a thin sheet that wrinkles takes of a strain: no compression. The wrinkles are not resolved; they are strain
// that costs nothing, so the energy is the least over all of them:
//
//   w(e) = min over b >= 0 and unit n of 1/2 (e + b n n) : K (e + b n n)                  [Pipkin1986], [Steigmann1990]
//
// taut: b = 0. Wrinkled: stress only along t, at a right angle to n. Slack: none. w is convex and its stress is never
// compressive, so its second derivative has no negative eigenvalue. A share `rest` of the sheet's own stiffness stays
// in compression, so that a slack sheet still has a shape.
#pragma once

#include "math/types.hpp"

namespace rhexis {

enum class SheetState { taut, wrinkled, slack };

struct TensionField {
    SheetState state = SheetState::taut;
    double energy = 0.0;          ///< per volume [Pa]
    Vec3 stress = Vec3::Zero();   ///< (11, 22, 12) [Pa]
    Mat3 tangent = Mat3::Zero();  ///< d stress / d strain, symmetric, positive definite for rest > 0 [Pa]
};

/// strain: (e11, e22, 2 e12); stiffness: plane_stiffness(); rest: 0 to 1.
TensionField tension_field(const Vec3& strain, const Mat3& stiffness, double rest);

}  // namespace rhexis
