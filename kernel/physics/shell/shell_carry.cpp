// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_carry.hpp"

#include <algorithm>

#include <Eigen/LU>

#include "base/index.hpp"
#include "math/rotation.hpp"
#include "physics/contact/tool_shape.hpp"

namespace rhexis {
namespace {

constexpr double from_end = 1.0;       // of the tube: what comes no nearer is shut in [mm]
constexpr double carried_share = 0.6;  // of its nodes in the tube: then the rest goes with it too

struct RigidMotion {
    Vec3 centre = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    Vec3 spin = Vec3::Zero();
    [[nodiscard]] Vec3 at(const Vec3& place) const { return velocity + spin.cross(place - centre); }
};

std::vector<std::size_t> nodes_within(const TubeModel& tube, const Pose& carrier, const std::vector<Vec3>& places) {
    std::vector<std::size_t> inside;
    for (std::size_t n = 0; n < places.size(); ++n) {
        if (within_bore(tube, tube.pose.to_body(carrier.to_body(places[n])))) {
            inside.push_back(n);
        }
    }
    return inside;
}

bool is_carried(const std::vector<std::size_t>& inside, const ShellState& state) {
    return static_cast<double>(inside.size()) >= carried_share * static_cast<double>(state.position.size());
}

/// That takes the most out of the nodes' velocities, by least squares.
RigidMotion fitted(const ShellState& state, const std::vector<std::size_t>& nodes) {
    RigidMotion motion;
    for (const std::size_t n : nodes) {
        motion.centre += state.position[n] / static_cast<double>(nodes.size());
        motion.velocity += state.velocity[n] / static_cast<double>(nodes.size());
    }
    Mat3 inertia = 1e-9 * Mat3::Identity();
    Vec3 momentum = Vec3::Zero();
    for (const std::size_t n : nodes) {
        const Vec3 arm = state.position[n] - motion.centre;
        inertia += arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose();
        momentum += arm.cross(state.velocity[n] - motion.velocity);
    }
    motion.spin = inertia.inverse() * momentum;
    return motion;
}

/// Of what goes with a body from one pose to another.
RigidMotion between(const Pose& from, const Pose& to, const Vec3& centre, double dt) {
    RigidMotion motion;
    motion.centre = centre;
    motion.velocity = (to.to_world(from.to_body(centre)) - centre) / dt;
    Quat turn = to.orientation * from.orientation.conjugate();
    turn.coeffs() *= turn.w() < 0.0 ? -1.0 : 1.0;
    motion.spin = 2.0 / dt * turn.vec();
    return motion;
}

bool touches_tool(const ShellState& state, int tool) {
    return std::any_of(state.touches.begin(), state.touches.end(), [tool](const ShellTouch& touch) {
        return touch.partner == ContactPartner::tool && touch.index == tool;
    });
}

}  // namespace

std::vector<Vec3> carried_velocity(const ShellState& state, const ShellPartners& partners, double dt) {
    std::vector<Vec3> result;
    for (std::size_t t = 0; t < partners.tube_tools.size(); ++t) {
        const int tool = partners.tube_tools[t];
        const ToolState& carrier = touches_tool(state, tool) ? partners.tool_states[at(tool)] : partners.tube_states[t];
        const std::vector<std::size_t> inside =
            nodes_within(partners.tubes[t], pose_within(partners.tube_states[t], partners.from), state.position);
        if (!is_carried(inside, state)) {
            continue;
        }
        if (result.empty()) {
            for (std::size_t n = 0; n < state.position.size(); ++n) {
                result.push_back(state.velocity[n]);
                result.push_back(state.spin[n]);
            }
        }
        const RigidMotion went = fitted(state, inside);
        const RigidMotion goes =
            between(pose_within(carrier, partners.from), pose_within(carrier, partners.to), went.centre, dt);
        for (std::size_t n = 0; n < state.position.size(); ++n) {
            result[2 * n] += goes.at(state.position[n]) - went.at(state.position[n]);
            result[2 * n + 1] += goes.spin - went.spin;
        }
    }
    return result;
}

bool lies_in(const TubeModel& tube, const Pose& carrier, const ShellState& state) {
    return is_carried(nodes_within(tube, carrier, state.position), state);
}

bool is_shut_in(const TubeModel& tube, const Pose& carrier, const ShellState& state) {
    return std::all_of(state.position.begin(), state.position.end(), [&](const Vec3& place) {
        return within_bore(tube, tube.pose.to_body(carrier.to_body(place)) + from_end * Vec3::UnitZ());
    });
}

ShellState taken_along(const ShellState& state, const Pose& carrier) {
    const Quat back = carrier.orientation.conjugate();
    ShellState out = moved(state, {-(back * carrier.position), back});
    stop(out);
    out.touches.clear();
    out.loaded = true;
    return out;
}

}  // namespace rhexis
