// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the bag as a rigid body on its zonules. Its inertia is that of a thin shell and its drag that of a
// ball of the same mean radius, both without direction; its weight is carried by the fluid around it.
#pragma once

#include "flow/bag.hpp"
#include "physics/solid/implicit_solid.hpp"

namespace rhexis {

/// Mean square distance of the wall from the centre [mm^2].
double bag_radius_squared(const BagModel& bag);

/// Moment of inertia about any axis through the centre [g mm^2].
double bag_inertia(const BagModel& bag);

/// Force and torque about the centre at a pose: of the zonules that hold, of hooks, and of the vitreous where that
/// holds the bag.
Vec6 suspension_wrench(const BagModel& bag, const BagState& state, const Pose& pose);

/// Springs, drag, load and inertia at the end of an implicit step of dt [s] that moved the bag from `state` to pose.
RigidTerm bag_term(const BagModel& bag, const BagState& state, const Pose& pose, const Vec6& velocity, double dt);

/// Explicit: mass and moment of inertia with which the bag answers an impulse within a substep of dt [s]. Drag is taken
/// at the end of the substep, stable for any dt, and resists impulses as well.
struct BagInertia {
    double mass = 0.0;     ///< [g]
    double turning = 0.0;  ///< [g mm^2]
};
BagInertia bag_response(const BagModel& bag, double dt);

/// Explicit: velocity after zonules, vitreous, load and drag have acted for dt [s].
void accelerate_bag(const BagModel& bag, double dt, BagState& state);

/// Explicit: pose after dt [s] at the present velocity.
void move_bag(double dt, BagState& state);

}  // namespace rhexis
