// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/globe_roll.hpp"

#include <algorithm>
#include <array>

namespace rhexis {

namespace {

constexpr double stands_in = 0.3;  ///< of the cornea's front: a tip that is deeper stands in the eye [mm]
constexpr double passes = 4.0;     ///< a shaft that is farther from a wound goes through none [mm]

double wound_width(const WorldModel& model, const WorldState& state, std::size_t lip) {
    return state.wounds && state.wounds->wounds[lip].cut ? state.wounds->wounds[lip].width : model.globe->widths[lip];
}

double tunnel_length(const WorldModel& model, const WorldState& state, std::size_t lip) {
    return state.wounds && state.wounds->wounds[lip].cut ? state.wounds->wounds[lip].tunnel : model.globe->tunnel;
}

/// Blades and needles make their own way, a sponge stays outside.
bool stands_in_wounds(ToolKind kind) {
    return kind != ToolKind::blade && kind != ToolKind::needle && kind != ToolKind::sponge;
}

/// A soft sleeve or a nozzle that goes along with the lips that it bends.
bool fills_wound(ToolKind kind) { return kind == ToolKind::phaco || kind == ToolKind::injector; }

struct Nearest {
    Vec3 off = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();
    double distance = 1e9;
};

/// Of the axes of a tool's parts to a place.
Nearest nearest_axis(const ToolModel& tool, const Pose& pose, const Vec3& place) {
    Nearest best;
    for (const RoundedCone& part : tool.parts) {
        const Vec3 a = pose.to_world(part.a);
        const Vec3 b = pose.to_world(part.b);
        const double square = (b - a).squaredNorm();
        const double share = square > 0.0 ? std::clamp((place - a).dot(b - a) / square, 0.0, 1.0) : 0.0;
        const Vec3 off = a + share * (b - a) - place;
        if (square > 0.0 && off.norm() < best.distance) {
            best = {off, (b - a) / std::sqrt(square), off.norm()};
        }
    }
    return best;
}

/// Least energy of orbit and lips, the orbit dragging behind: stiff * roll + torque of the lips = 0, linear in the
/// roll.
struct Balance {
    Mat3 matrix = Mat3::Zero();
    Vec3 side = Vec3::Zero();
};

Mat3 cross_matrix(const Vec3& v) {
    Mat3 m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
}

/// A lip at r from the centre goes by roll x r = -[r] roll; its spring wants that to be `away`, across the shaft.
void add_lip(double stiffness, const Vec3& r, const Vec3& axis, const Vec3& away, Balance& balance) {
    const Mat3 across = Mat3::Identity() - axis * axis.transpose();
    const Mat3 arm = -across * cross_matrix(r);
    balance.matrix += stiffness * arm.transpose() * arm;
    balance.side += stiffness * arm.transpose() * away;
}

}  // namespace

Vec3 lip_place(const WorldModel& model, const WorldState& state, std::size_t lip) {
    return state.wounds && state.wounds->wounds[lip].cut ? state.wounds->wounds[lip].inner : model.globe->lips[lip];
}

std::optional<ShaftAtWound> shaft_at_wound(const WorldModel& model, const WorldState& state, int tool,
                                           const ToolState& tool_state) {
    const GlobeModel& globe = *model.globe;
    const ToolModel& instrument = model.tools[static_cast<std::size_t>(tool)];
    const double depth = globe.front_radius - (tool_state.pose.position - globe.front_centre).norm();
    if (!tool_state.present || !stands_in_wounds(instrument.kind) || !(depth > stands_in)) {
        return std::nullopt;
    }
    std::optional<ShaftAtWound> found;
    double least = passes;
    for (std::size_t lip = 0; lip < lip_count; ++lip) {
        const Nearest near = nearest_axis(instrument, tool_state.pose, lip_place(model, state, lip));
        if (wound_width(model, state, lip) > 0.0 && near.distance < least) {
            least = near.distance;
            found = ShaftAtWound{near.off - near.off.dot(near.axis) * near.axis, near.axis, lip};
        }
    }
    return found;
}

void roll_globe(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state) {
    const GlobeModel& globe = *model.globe;
    GlobeState& now = *state.globe;
    const GlobeState before = now;
    const Quat turned = rotation_of(before);
    const double drag = globe.stiffness * globe.lag / dt;
    Balance balance;
    balance.matrix = (globe.stiffness + drag) * Mat3::Identity();
    balance.side = drag * before.roll;
    std::array<Vec3, lip_count> away{};
    std::array<Vec3, lip_count> axis{};
    std::array<bool, lip_count> held{};
    for (int tool = 0; tool < static_cast<int>(tools.size()); ++tool) {
        const std::optional<ShaftAtWound> shaft =
            shaft_at_wound(model, state, tool, tools[static_cast<std::size_t>(tool)]);
        if (!shaft || held[shaft->lip]) {
            continue;  // of two in one wound the first leads it
        }
        const std::size_t lip = shaft->lip;
        const Vec3 rest = lip_place(model, state, lip);
        const Vec3 room = to_room(globe, before, rest + shaft->off) - rest;
        held[lip] = true;
        axis[lip] = turned * shaft->axis;
        away[lip] = room - room.dot(axis[lip]) * axis[lip];
        add_lip(globe.lip_stiffness, rest - globe.centre, axis[lip], away[lip], balance);
    }
    now.roll = balance.matrix.llt().solve(balance.side);
    const double size = now.roll.norm();
    now.roll *= size > globe.most ? globe.most / size : 1.0;
    for (std::size_t lip = 0; lip < lip_count; ++lip) {
        Lip& place = now.lips[lip];
        place.excursion = held[lip] ? away[lip].norm() : 0.0;
        place.deflection.setZero();
        if (!held[lip]) {
            continue;
        }
        const Vec3 gone = now.roll.cross(lip_place(model, state, lip) - globe.centre);
        Vec3 left = away[lip] - gone;
        left -= left.dot(axis[lip]) * axis[lip];
        place.deflection = turned.conjugate() * left;
        const double more = globe.stays * (left.norm() - globe.bears) - place.enlargement;
        if (more > 0.0) {
            place.enlargement += more;
            if (state.wounds && state.wounds->wounds[lip].cut) {
                state.wounds->wounds[lip].width += more;
            }
        }
    }
}

double pressed_open(const WorldModel& model, std::span<const ToolState> tools, const WorldState& state) {
    double sum = 0.0;
    std::array<bool, lip_count> counted{};
    for (int tool = 0; tool < static_cast<int>(tools.size()); ++tool) {
        const std::optional<ShaftAtWound> shaft =
            shaft_at_wound(model, state, tool, tools[static_cast<std::size_t>(tool)]);
        if (!shaft || counted[shaft->lip] || fills_wound(model.tools[static_cast<std::size_t>(tool)].kind)) {
            continue;
        }
        const std::size_t lip = shaft->lip;
        counted[lip] = true;
        sum += pressed_conductance(*model.globe, state.globe->lips[lip], wound_width(model, state, lip),
                                   tunnel_length(model, state, lip));
    }
    return sum;
}

}  // namespace rhexis
