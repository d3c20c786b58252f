// SPDX-License-Identifier: GPL-3.0-or-later
// The capsular bag around a lens, hung on zonules.
#pragma once

#include "flow/bag.hpp"
#include "mesh/half_ellipsoids.hpp"

namespace rhexis {

/// Axial stiffness of the whole ring of zonules [uN/mm]: 22, 16.5 and 14 mN/mm at 60, 73 and 90 years, constant outside
/// [Mikielewicz2011]. Their load was measured against a displacement of the ring; it is taken as the force that moves
/// the bag along the axis of the eye by 1 mm, in the first 0.2 mm.
double zonule_ring_stiffness(double age);

/// The bag: the lens's contour and a clearance of 0.03 mm, opened by a capsulorhexis of 5.2 mm, on 24 meridians with
/// one anterior and one posterior zonule each. lens_mass [g] only scales the damping.
BagModel make_bag(const HalfEllipsoids& lens, double lens_mass, double age);

/// Where the line from the axis through a node meets the ring of the ciliary body, from which such a zonule comes [mm].
Vec3 ciliary_place(const Vec3& node, const ZonuleSpring& zonule);

/// Force that resists a small displacement of the whole bag along a unit direction, per mm [uN/mm].
double suspension_stiffness(const BagModel& bag, const Vec3& direction);

}  // namespace rhexis
