// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/fluid/chamber_flow.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "math/types.hpp"

namespace rhexis {

namespace {

constexpr double longest_substep = 1e-3;           ///< [s]
constexpr double alexander = 0.29289321881345248;  ///< 1 - sqrt(1/2)
constexpr int eye = 0;
constexpr int tube = 1;

/// The network of one step: what its flows have in common.
struct Network {
    const ChamberModel& model;
    double bottle = 0.0;    ///< [Pa]
    double infusion = 0.0;  ///< conductances [mm^3/(s Pa)]
    double tip = 0.0;
    double vent = 0.0;
    double leak = 0.0;
    double pump_flow = 0.0;  ///< [mm^3/s]
    double vacuum_limit = 0.0;
};

Network make_network(const ChamberModel& model, const ChamberControl& control) {
    Network network{model};
    network.bottle = bottle_pressure(model, control.bottle_height);
    network.infusion = control.irrigation ? 1.0 / model.infusion_resistance : 0.0;
    // As 1 / (R_tube + R_tip / open), without dividing by an opening of zero.
    network.tip = control.tip_open / (model.tip_resistance + control.tip_open * model.tube_resistance);
    network.vent = control.vent ? 1.0 / model.vent_resistance : 0.0;
    network.leak = control.wound_open * model.leak_conductance;
    network.pump_flow = control.pump_flow;
    network.vacuum_limit = control.vacuum_limit;
    return network;
}

struct Flows {
    double infusion = 0.0;
    double tip = 0.0;
    double pump = 0.0;
    double leak = 0.0;
    double vent = 0.0;
};

/// Share of its full flow that the pump moves.
double pump_share(const Network& network, const Vec2& pressure) {
    return std::clamp((network.vacuum_limit + pressure[tube]) / network.model.pump_band, 0.0, 1.0);
}

Flows flows_at(const Network& network, const Vec2& pressure) {
    return {network.infusion * (network.bottle - pressure[eye]), network.tip * (pressure[eye] - pressure[tube]),
            network.pump_flow * pump_share(network, pressure), network.leak * std::max(pressure[eye], 0.0),
            network.vent * std::max(-pressure[tube], 0.0)};
}

Vec2 volume_rate(const Flows& q) { return {q.infusion - q.tip - q.leak, q.tip + q.vent - q.pump}; }

Vec2 pressures(const ChamberModel& model, const Vec2& volume) {
    return {eye_pressure(model, volume[eye]), tube_pressure(model, volume[tube])};
}

/// Derivative of -volume_rate(flows_at(pressure)): symmetric, positive semidefinite [mm^3/(s Pa)].
Mat2 conductance(const Network& network, const Vec2& pressure) {
    const ChamberModel& model = network.model;
    const double share = pump_share(network, pressure);
    const double leak = pressure[eye] > 0.0 ? network.leak : 0.0;
    const double vent = pressure[tube] < 0.0 ? network.vent : 0.0;
    const double pump = share > 0.0 && share < 1.0 ? network.pump_flow / model.pump_band : 0.0;
    Mat2 matrix;
    matrix << network.infusion + network.tip + leak, -network.tip, -network.tip, network.tip + vent + pump;
    return matrix;
}

/// The volumes v with v = known + h volume_rate(v). Newton; halving takes care of the kinks.
Vec2 solve_stage(const Network& network, const Vec2& known, double h, Vec2 volume) {
    const ChamberModel& model = network.model;
    const auto residual = [&](const Vec2& v) {
        return Vec2(v - known - h * volume_rate(flows_at(network, pressures(model, v))));
    };
    const double enough = 1e-13 * (1.0 + known.norm());
    Vec2 error = residual(volume);
    for (int iteration = 0; iteration < 50 && error.norm() > enough; ++iteration) {
        const Vec2 stiffness(eye_stiffness(model, volume[eye]), 1.0 / model.tube_compliance);
        const Mat2 slope =
            Mat2::Identity() + h * conductance(network, pressures(model, volume)) * stiffness.asDiagonal();
        const Vec2 step = slope.inverse() * error;
        double length = 1.0;
        Vec2 next = volume - step;
        Vec2 next_error = residual(next);
        while (!(next_error.norm() < error.norm()) && length > 1e-6) {
            length *= 0.5;
            next = volume - length * step;
            next_error = residual(next);
        }
        if (!(next_error.norm() < error.norm())) {
            break;  // as good as rounding allows
        }
        volume = next;
        error = next_error;
    }
    return volume;
}

Flows sum(const Flows& a, double weight_a, const Flows& b, double weight_b) {
    return {weight_a * a.infusion + weight_b * b.infusion, weight_a * a.tip + weight_b * b.tip,
            weight_a * a.pump + weight_b * b.pump, weight_a * a.leak + weight_b * b.leak,
            weight_a * a.vent + weight_b * b.vent};
}

/// One step of the two-stage SDIRK of order 2. Volumes change by flows alone, so that they balance to rounding
/// whatever remains of a stage's residual. Returns what flowed [mm^3].
Flows substep(const Network& network, double h, Vec2& volume) {
    const Vec2 first = solve_stage(network, volume, alexander * h, volume);
    const Flows early = flows_at(network, pressures(network.model, first));
    const Vec2 known = volume + (1.0 - alexander) * h * volume_rate(early);
    const Vec2 second = solve_stage(network, known, alexander * h, first);
    const Flows moved =
        sum(early, (1.0 - alexander) * h, flows_at(network, pressures(network.model, second)), alexander * h);
    volume += volume_rate(moved);
    return moved;
}

}  // namespace

ChamberFlows advance_chamber(const ChamberModel& model, const ChamberControl& control, double dt, ChamberState& state) {
    RHEXIS_ASSERT(check(model).ok() && check(control).ok() && check(model, state).ok() && check_chamber_step(dt).ok());
    const Network network = make_network(model, control);
    const int substeps = std::max(1, static_cast<int>(std::ceil(dt / longest_substep - 1e-9)));
    Vec2 volume(state.eye_volume, state.tube_volume);
    Flows moved;
    ChamberFlows result;
    result.lowest_eye_pressure = result.highest_eye_pressure = eye_pressure(model, volume[eye]);
    for (int i = 0; i < substeps; ++i) {
        moved = sum(moved, 1.0, substep(network, dt / substeps, volume), 1.0);
        const double now = eye_pressure(model, volume[eye]);
        result.lowest_eye_pressure = std::min(result.lowest_eye_pressure, now);
        result.highest_eye_pressure = std::max(result.highest_eye_pressure, now);
    }
    state.eye_volume = volume[eye];
    state.tube_volume = volume[tube];
    state.totals.infused += moved.infusion;
    state.totals.vented += moved.vent;
    state.totals.aspirated += moved.pump;
    state.totals.leaked += moved.leak;
    result.infusion = moved.infusion / dt;
    result.tip = moved.tip / dt;
    result.pump = moved.pump / dt;
    result.leak = moved.leak / dt;
    result.vent = moved.vent / dt;
    return result;
}

}  // namespace rhexis
