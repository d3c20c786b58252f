// SPDX-License-Identifier: GPL-3.0-or-later
// Provocations of thin shells by load and by what squeezes them, short as tests and long as benchmarks. Each returns
// what it measured; the gates stand where it is called.
#pragma once

namespace rhexis::scenes {

struct FlatStart {
    int iterations = 0;  ///< of Newton's method, in statics for the whole load, in steps of the first
    int unbalanced = 0;  ///< loads or steps that did not converge
    double apart = 0.0;  ///< of the end from the known one, relative
};
/// T9: a flat slit ring under all of its load at once, against the same load in eight parts, by statics.
FlatStart load_flat_ring();
/// T9: a flat strip whose end is sheared by a whole load within a step of dt [s], until it rests; against the elastica.
FlatStart load_flat_strip(double dt);

struct SnapPath {
    double upper = 0.0;  ///< load factor at the first limit point
    double lower = 0.0;  ///< and at the second
    bool passed = false;
};
/// T10: the path of equilibria of a hinged roof through both limit points.
SnapPath follow_roof(int each_way);

struct SnapThrough {
    int unbalanced = 0;   ///< steps
    double beyond = 0.0;  ///< where it comes to rest, as a share of where it lies after the jump [mm / mm]
    double speed = 0.0;   ///< at the end over the fastest on the way
};
/// T10: the same roof stepped under a load above its limit.
SnapThrough snap_roof();

/// How the pulled cylinder is stepped.
enum class CylinderWay {
    world,             ///< as in a scene: what does not balance is redone in smaller steps
    predicted_stress,  ///< tangents with predicted stress, whatever does not balance is kept
    true_stress,       ///< tangents with the true stress, likewise
};
struct CylinderRuns {
    int runs = 0;
    int elsewhere = 0;  ///< that end away from the equilibrium to which statics leads
    int hidden = 0;     ///< of these, without any step that was flagged as not balanced
    int flagged = 0;    ///< steps
    int redone = 0;     ///< tries thrown away
    int iterations = 0;
};
/// T10: a cylinder pulled apart within one step of dt [s] by each of eight loads, on two meshes or on all of four.
CylinderRuns pull_cylinders(CylinderWay way, double dt, bool quick);

struct Squeeze {
    double jitter = 0.0;   ///< of a jaw's force in the last half, from step to step, rms over its mean
    double deepest = 0.0;  ///< penetration over thickness, or over the edge of the mesh
    double gain = 0.0;     ///< energy beyond the work done, over that work
    double uneven = 0.0;   ///< difference of the jaws' forces over one of them
    int failures = 0;      ///< steps that did not balance, or that no way could solve
};
/// T12: two rods close on a strip of a shell and stand still.
Squeeze squeeze_strip();

struct Stack {
    double deepest = 0.0;  ///< penetration over thickness
    double drift = 0.0;    ///< of any node in the second half, per second [mm/s]
    double borne = 0.0;    ///< force of the ground over the weight
    double gain = 0.0;     ///< largest energy beyond what weight brought, over that
    int unbalanced = 0;    ///< steps
};
/// T13: five plates on each other, or one a thousand times as heavy as what it lies on.
Stack stack_plates(bool heavy);

struct LiftedForce {
    double error = 0.0;    ///< of the plane's force, against the elastica
    double deepest = 0.0;  ///< over thickness
    int unbalanced = 0;    ///< steps
};
/// T15: a strip bent by a plane, its free end turned by up to a radian against its clamped one.
LiftedForce lift_strip(double lift, double tilt);

}  // namespace rhexis::scenes
