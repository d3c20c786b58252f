// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/bag_motion.hpp"

#include "math/rotation.hpp"

namespace rhexis {

namespace {

/// place: in the bag's frame.
void add_force(const Pose& pose, const Vec3& place, const Vec3& force, Vec6& wrench) {
    wrench.head<3>() += force;
    wrench.tail<3>() += (pose.orientation * place).cross(force);
}

void add_stiffness(const Pose& pose, const Vec3& place, const Mat3& stiffness, RigidTerm& term) {
    const Mat3 arm = cross_matrix(pose.orientation * place);  // point moves by d - arm theta
    term.stiffness.topLeftCorner<3, 3>() += stiffness;
    term.stiffness.topRightCorner<3, 3>() -= stiffness * arm;
    term.stiffness.bottomLeftCorner<3, 3>() += arm * stiffness;
    term.stiffness.bottomRightCorner<3, 3>() -= arm * stiffness * arm;
}

}  // namespace

double bag_radius_squared(const BagModel& bag) {
    const double depth = 0.5 * (bag.shape.anterior + bag.shape.posterior);
    return (2.0 * bag.shape.radius * bag.shape.radius + depth * depth) / 3.0;
}

double bag_inertia(const BagModel& bag) { return 2.0 / 3.0 * bag.mass * bag_radius_squared(bag); }

Vec6 suspension_wrench(const BagModel& bag, const BagState& state, const Pose& pose) {
    const ZonuleShares shares(bag, state);
    Vec6 wrench = Vec6::Zero();
    for (std::size_t i = 0; i < bag.zonules.size(); ++i) {
        const ZonuleSpring& spring = bag.zonules[i];
        Vec3 force = zonule_force(spring, pose);
        if (!shares.all_whole()) {
            force = shares.of(i) * force + missing_pull(bag, i, shares.of(i));
        }
        add_force(pose, spring.on_bag, force, wrench);
    }
    if (state.zonules) {
        for (const CapsuleHook& hook : state.zonules->hooks) {
            add_force(pose, hook.on_bag, hook_force(*bag.breakable, hook, pose), wrench);
        }
    }
    wrench.z() += bag.cushion * (state.cushion_z - pose.position.z());
    return wrench;
}

RigidTerm bag_term(const BagModel& bag, const BagState& state, const Pose& pose, const Vec6& velocity, double dt) {
    const double turning_drag = bag.damping * bag_radius_squared(bag);
    RigidTerm term;
    term.mass.setZero();
    term.mass.diagonal() << Vec3::Constant(bag.mass), Vec3::Constant(bag_inertia(bag));
    term.force = suspension_wrench(bag, state, pose) + state.load;
    term.force.head<3>() -= bag.damping * velocity.head<3>();
    term.force.tail<3>() -= turning_drag * velocity.tail<3>();
    const ZonuleShares shares(bag, state);
    for (std::size_t i = 0; i < bag.zonules.size(); ++i) {
        Mat3 stiffness = zonule_stiffness(bag.zonules[i], pose);
        if (!shares.all_whole()) {
            stiffness *= shares.of(i);
        }
        add_stiffness(pose, bag.zonules[i].on_bag, stiffness, term);
    }
    if (state.zonules) {
        for (const CapsuleHook& hook : state.zonules->hooks) {
            add_stiffness(pose, hook.on_bag, hook_stiffness(*bag.breakable, hook, pose), term);
        }
    }
    term.stiffness(2, 2) += bag.cushion;
    for (int i = 0; i < 3; ++i) {
        term.stiffness(i, i) += bag.damping / dt;
        term.stiffness(3 + i, 3 + i) += turning_drag / dt;
    }
    return term;
}

BagInertia bag_response(const BagModel& bag, double dt) {
    return {bag.mass + dt * bag.damping, bag_inertia(bag) + dt * bag.damping * bag_radius_squared(bag)};
}

void accelerate_bag(const BagModel& bag, double dt, BagState& state) {
    const Vec6 wrench = suspension_wrench(bag, state, state.pose) + state.load;
    const BagInertia response = bag_response(bag, dt);
    state.velocity = (bag.mass * state.velocity + dt * wrench.head<3>()) / response.mass;
    state.angular_velocity = (bag_inertia(bag) * state.angular_velocity + dt * wrench.tail<3>()) / response.turning;
}

void move_bag(double dt, BagState& state) {
    state.pose.position += dt * state.velocity;
    state.pose.orientation = turned(state.pose.orientation, dt * state.angular_velocity);
}

}  // namespace rhexis
