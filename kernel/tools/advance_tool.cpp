// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/advance_tool.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace rhexis {

namespace {

/// Why a sample cannot be used; empty if it can.
std::string sample_fault(const ToolState& previous, const DeviceSample& sample, double dt,
                         const ToolSettings& settings) {
    const Vec3& position = sample.pose.position;
    const Quat& orientation = sample.pose.orientation;
    if (!position.allFinite() || !orientation.coeffs().allFinite() || !std::isfinite(sample.jaw) ||
        !std::isfinite(sample.pedal)) {
        return "a number is not finite";
    }
    if (!(position.norm() <= settings.max_distance)) {
        return "tip " + short_number(position.norm()) + " mm from the eye, allowed " +
               short_number(settings.max_distance) + " mm";
    }
    if (!(std::abs(orientation.norm() - 1.0) < 1e-2)) {
        return "orientation of length " + short_number(orientation.norm()) + ", allowed 1";
    }
    const double speed = previous.present ? (position - previous.pose.position).norm() / dt : 0.0;
    if (!(speed <= settings.max_speed)) {
        return "jump at " + short_number(speed) + " mm/s, allowed " + short_number(settings.max_speed) + " mm/s";
    }
    return {};
}

/// Twice the vector part of the turn between two orientations: the angle to third order in it [rad].
Vec3 turn_between(const Quat& from, const Quat& to) {
    const Quat turn = to * from.conjugate();
    return (turn.w() < 0.0 ? -2.0 : 2.0) * turn.vec();
}

/// Time with ultrasound within the first `time` of a train of pulses [s].
double pulsed_time(double time, double period, double duty) {
    const double whole = std::floor(time / period);
    return whole * duty * period + std::min(time - whole * period, duty * period);
}

/// Share of a step with ultrasound, which began `since` before it.
double pulse_share(double since, double dt, const ToolSettings& settings) {
    if (!(settings.pulse_hz > 0.0)) {
        return 1.0;
    }
    const double period = 1.0 / settings.pulse_hz;
    return (pulsed_time(since + dt, period, settings.duty) - pulsed_time(since, period, settings.duty)) / dt;
}

void apply_pedal_to_cutter(const ToolSettings& settings, ToolState& state) {
    const double second = std::clamp(state.pedal - 1.0, 0.0, 1.0);
    const double third = std::clamp(state.pedal - 2.0, 0.0, 1.0);
    state.irrigation = state.pedal >= 1.0 && settings.infusion;
    state.bottle_height = settings.bottle_height;
    state.aspiration = settings.cut_first ? third : second;
    state.power = (settings.cut_first ? second : third) > 0.0 ? settings.cut_rate : 0.0;
    state.pump_flow = state.aspiration * settings.cutter_flow;
    state.vacuum_limit = state.aspiration * settings.cutter_vacuum;
}

/// Pedal 2 is travelled from 1 to 2; beyond that there is nothing more.
void apply_pedal_to_aspirator(const ToolSettings& settings, ToolState& state) {
    state.irrigation = state.pedal >= 1.0 && settings.infusion;
    state.bottle_height = settings.bottle_height;
    state.aspiration = std::clamp(state.pedal - 1.0, 0.0, 1.0);
    state.pump_flow = state.aspiration * settings.ia_flow;
    state.vacuum_limit = state.aspiration * settings.ia_vacuum;
}

void apply_pedal(const ToolModel& model, double pedal, double dt, const ToolSettings& settings, ToolState& state) {
    state.pedal = std::clamp(pedal, 0.0, 3.0);
    if (model.kind == ToolKind::cutter) {
        apply_pedal_to_cutter(settings, state);
        return;
    }
    if (model.kind == ToolKind::aspirator) {
        apply_pedal_to_aspirator(settings, state);
        return;
    }
    if (model.kind != ToolKind::phaco) {
        return;
    }
    state.irrigation = state.pedal >= 1.0 && settings.infusion;
    state.aspiration = std::clamp(state.pedal - 1.0, 0.0, 1.0);
    state.bottle_height = settings.bottle_height;
    state.pump_flow = state.aspiration * settings.pump_flow;
    state.vacuum_limit = state.aspiration * settings.vacuum_limit;
    const double wanted = std::clamp(settings.power_limit, 0.0, 1.0) * std::clamp(state.pedal - 2.0, 0.0, 1.0);
    const double since = state.ultrasound_s;
    state.ultrasound_s = wanted > 0.0 ? since + dt : 0.0;
    state.power = wanted > 0.0 ? wanted * pulse_share(since, dt, settings) : 0.0;
}

}  // namespace

ToolState hold_tool(const ToolState& previous) {
    ToolState state = previous;
    state.previous_pose = previous.pose;
    state.previous_jaw = previous.jaw;
    state.velocity.setZero();
    state.angular_velocity.setZero();
    return state;
}

ToolStep next_tool(const ToolModel& model, const ToolState& previous, const DeviceSample& sample, double dt,
                   const ToolSettings& settings) {
    if (!sample.present) {
        return {ToolState{}, {}};
    }
    if (std::string reason = sample_fault(previous, sample, dt, settings); !reason.empty()) {
        return {hold_tool(previous), std::move(reason)};
    }
    ToolState state;
    state.present = true;
    state.pose = sample.pose;
    state.pose.orientation.normalize();
    state.previous_pose = previous.present ? previous.pose : state.pose;
    state.velocity = (state.pose.position - state.previous_pose.position) / dt;
    state.angular_velocity = turn_between(state.previous_pose.orientation, state.pose.orientation) / dt;
    state.jaw = std::clamp(sample.jaw, 0.0, 1.0);
    state.previous_jaw = previous.present ? previous.jaw : state.jaw;
    state.ultrasound_s = previous.present ? previous.ultrasound_s : 0.0;
    apply_pedal(model, sample.pedal, dt, settings, state);
    return {state, {}};
}

}  // namespace rhexis
