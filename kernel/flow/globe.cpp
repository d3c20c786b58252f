// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/globe.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

Quat rotation_of(const GlobeState& state) {
    const Vec3 half = 0.5 * state.roll;
    return Quat(1.0, half.x(), half.y(), half.z()).normalized();
}

double roll_angle(const GlobeState& state) { return 2.0 * std::atan(0.5 * state.roll.norm()); }

Vec3 to_room(const GlobeModel& model, const GlobeState& state, const Vec3& place) {
    return rotation_of(state) * (place - model.centre) + model.centre;
}

Pose to_room(const GlobeModel& model, const GlobeState& state, const Pose& pose) {
    return {to_room(model, state, pose.position), (rotation_of(state) * pose.orientation).normalized()};
}

Vec3 to_eye(const GlobeModel& model, const GlobeState& state, const Vec3& place) {
    return rotation_of(state).conjugate() * (place - model.centre) + model.centre;
}

Pose to_eye(const GlobeModel& model, const GlobeState& state, const Pose& pose) {
    return {to_eye(model, state, pose.position), (rotation_of(state).conjugate() * pose.orientation).normalized()};
}

double pressed_conductance(const GlobeModel& model, const Lip& lip, double width, double tunnel) {
    const double slit = std::clamp(model.opening * (lip.deflection.norm() - model.opens), 0.0, model.widest);
    return width * slit * slit * slit / (12.0 * model.viscosity * std::max(tunnel, 0.3));
}

}  // namespace rhexis
