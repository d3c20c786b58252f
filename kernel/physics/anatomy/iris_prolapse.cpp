// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/iris_prolapse.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

namespace {

constexpr double in_wound = 0.2;     ///< so long a prolapse lies in the wound and takes all of its pressure [mm]
constexpr double full_tunnel = 0.5;  ///< length from which on all of the tunnel rubs on it [mm]. Proposal
constexpr double least_out = 0.1;    ///< a shorter one has slipped back [mm]
constexpr double usual_pressure = 20.0 * pascal_per_mmhg;

double distance_to_line(const Vec3& a, const Vec3& unit, const Vec3& place) {
    const Vec3 off = place - a;
    return (off - off.dot(unit) * unit).norm();
}

/// Share of the pressure that falls between iris and inner lip: as between plates, with the third power of the gap.
double near_lip(const WorldModel& model, const WorldState& state, const Wound& wound) {
    const double gap = std::max(0.0, wound.inner.z() - state.iris->z - 0.5 * model.iris->thickness);
    const double share = gap / model.prolapse->near;
    return 1.0 / (1.0 + share * share * share);
}

/// What stands in the way out, as the length that it leaves the iris; and a stroke over the outer lip.
struct Met {
    double room = 1e9;  ///< [mm]
    bool stroke = false;
};

Met meet_tools(const WorldModel& model, const WorldState& state, const Wound& wound, std::span<const ToolState> tools) {
    const ProlapseModel& own = *model.prolapse;
    const Vec3 out = (wound.outer - wound.inner).normalized();
    Met met;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const ToolKind kind = model.tools[i].kind;
        if (!tools[i].present || kind == ToolKind::sponge || kind == ToolKind::needle) {
            continue;
        }
        const Vec3& tip = tools[i].pose.position;
        const bool before = distance_to_line(wound.inner, out, tip) < 0.5 * wound.width;
        const double along = (tip - wound.inner).dot(out);
        const bool outside = below_front(*model.wounds, tip) < 0.1;
        if (outside && (tip - wound.outer).norm() < own.stroke_reach + 0.5 * wound.width &&
            tools[i].velocity.norm() > own.stroke_speed && kind != ToolKind::phaco) {
            const double inwards = -tools[i].velocity.dot(out);
            met.stroke = met.stroke || inwards < 0.7 * tools[i].velocity.norm();
        }
        if (before && along < wound.tunnel + state.prolapse->length && !outside) {
            met.room = std::min(met.room, std::max(0.0, along));
        }
    }
    return met;
}

/// A shaft in the main wound fills it.
bool filled(const WorldModel& model, const Wound& wound, std::span<const ToolState> tools) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (!tools[i].present || !(beyond_back(*model.wounds, tools[i].pose.position) > 0.0)) {
            continue;
        }
        for (const RoundedCone& part : model.tools[i].parts) {
            const Vec3 a = tools[i].pose.to_world(part.a);
            const Vec3 line = tools[i].pose.to_world(part.b) - a;
            const double square = line.squaredNorm();
            const double share = square > 0.0 ? std::clamp((wound.inner - a).dot(line) / square, 0.0, 1.0) : 0.0;
            if ((wound.inner - a - share * line).norm() < 0.5 * wound.width) {
                return true;
            }
        }
    }
    return false;
}

void push_back(const ProlapseModel& model, double room, double pressure, ProlapseState& prolapse) {
    const double pushed = prolapse.length - room;
    if (!(pushed > 0.0)) {
        return;
    }
    prolapse.length = room;
    prolapse.pushed += pushed;
    prolapse.damage =
        std::min(1.0, prolapse.damage + model.damage * pushed * (1.0 + std::max(0.0, pressure) / usual_pressure));
}

/// Where friction, which grows with what lies in the tunnel, stops what comes out, however long the step.
double farthest(double out, double stiffness, double rubs) {
    const double balance = (out - rubs) / stiffness;
    return balance > full_tunnel ? balance : out / (stiffness + rubs / full_tunnel);
}

}  // namespace

double pushed_length(const ProlapseModel& model, const ProlapseState& state, double pull, double width, double dt) {
    const double stiffness = model.stiffness * (1.0 - model.softer * state.damage);
    const double out = std::max(0.0, pull - model.holds) * model.patch * width;
    const double lies_in = std::min(1.0, state.length / full_tunnel);
    const double rubs = model.friction * (state.stroke_s > 0.0 ? model.stroked : 1.0);
    const double friction = lies_in * rubs;
    const double net = out - stiffness * state.length;
    if (std::abs(net) <= friction) {
        return state.length;
    }
    const double drive = out - std::copysign(friction, net);
    const double slow = model.drag / dt;
    const double length = std::clamp((slow * state.length + drive) / (slow + stiffness), 0.0, model.longest);
    return net > 0.0 ? std::min(length, std::max(state.length, farthest(out, stiffness, rubs))) : length;
}

void move_prolapse(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state) {
    const ProlapseModel& own = *model.prolapse;
    ProlapseState& prolapse = *state.prolapse;
    const Wound& wound = state.wounds->wounds[main_wound];
    prolapse.pull = 0.0;
    prolapse.stroke_s = std::max(0.0, prolapse.stroke_s - dt);
    if (wound.cut) {
        const double pressure = eye_pressure(*model.chamber, state.chamber->eye_volume);
        const double burn = burn_share(state.chamber->wound);
        const double open = std::clamp(gape_of(*model.wounds, wound, burn, pressure, wound.press), 0.0, 1.0);
        const Met met = meet_tools(model, state, wound, tools);
        prolapse.stroke_s = met.stroke ? own.stroke_s : prolapse.stroke_s;
        push_back(own, met.room, pressure, prolapse);
        const double share = prolapse.length > in_wound ? 1.0 : open * near_lip(model, state, wound);
        prolapse.pull = filled(model, wound, tools) ? 0.0 : std::max(0.0, pressure) * share;
        if (!filled(model, wound, tools)) {
            prolapse.length = std::min(met.room, pushed_length(own, prolapse, prolapse.pull, wound.width, dt));
        }
        if (prolapse.length < least_out && !(prolapse.pull > own.holds)) {
            prolapse.length = 0.0;
        }
        prolapse.most = std::max(prolapse.most, prolapse.length);
    }
    state.iris->pupil_radius *=
        std::max(0.3, (1.0 - own.narrows * prolapse.length) * (1.0 - own.narrows_damaged * prolapse.damage));
}

}  // namespace rhexis
