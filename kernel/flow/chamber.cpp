// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/chamber.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

// The eye: dP/dV = (1 + s (P / P_ref - 1)) / C. Counted from the collapse pressure P_c, with u = 1 + s (P / P_ref - 1):
//   u = u_c exp(y), y = s V / (C P_ref), so P = P_c + V u_c / C (exp(y) - 1) / y.
// That holds for s = 0 too (y = 0), where the eye is a linear tank.

namespace {

constexpr double gravity = 9810.0;                             ///< [mm/s^2]
constexpr double reference_pressure = 50.0 * pascal_per_mmhg;  ///< where eye_compliance holds [Pa]

/// u, the stiffness as a share of that at the reference pressure.
double relative_stiffness(const ChamberModel& model, double pressure) {
    return 1.0 + model.eye_stiffening * (pressure / reference_pressure - 1.0);
}

double exponent_per_volume(const ChamberModel& model) {
    return model.eye_stiffening / (model.eye_compliance * reference_pressure);
}

/// exp(y) - 1 for y >= 0. Written out, because libraries round it differently on different machines.
double exponential_less_one(double y) {
    constexpr int halvings = 6;
    const double x = y / (1 << halvings);
    double value = 0.0;
    for (int n = 9; n >= 1; --n) {
        value = (1.0 + value) * x / n;
    }
    for (int i = 0; i < halvings; ++i) {
        value *= value + 2.0;
    }
    return value;
}

/// log(1 + x) / x for x > 0. By square roots and a series: a library's logarithm differs between machines.
double logarithm_share(double x) {
    if (x < 1e-4) {
        return 1.0 - x * (0.5 - x / 3.0);
    }
    constexpr int halvings = 8;
    double root = 1.0 + x;
    for (int i = 0; i < halvings; ++i) {
        root = std::sqrt(root);
    }
    const double z = (root - 1.0) / (root + 1.0);
    const double square = z * z;
    const double series = 1.0 + square * (1.0 / 3.0 + square * (1.0 / 5.0 + square * (1.0 / 7.0 + square / 9.0)));
    return (1 << halvings) * 2.0 * z * series / x;
}

}  // namespace

double eye_pressure(const ChamberModel& model, double eye_volume) {
    const double linear = eye_volume * relative_stiffness(model, model.collapse_pressure) / model.eye_compliance;
    const double y = exponent_per_volume(model) * eye_volume;
    return model.collapse_pressure + (y > 0.0 ? linear * (exponential_less_one(y) / y) : linear);
}

double eye_stiffness(const ChamberModel& model, double eye_volume) {
    const double least = relative_stiffness(model, model.collapse_pressure) / model.eye_compliance;
    const double y = exponent_per_volume(model) * eye_volume;
    return y > 0.0 ? least * (1.0 + exponential_less_one(y)) : least;
}

double eye_volume(const ChamberModel& model, double pressure) {
    const double least = relative_stiffness(model, model.collapse_pressure);
    const double linear = (pressure - model.collapse_pressure) * model.eye_compliance / least;
    const double growth = relative_stiffness(model, pressure) / least - 1.0;
    double volume = growth > 0.0 ? linear * logarithm_share(growth) : linear;
    // The logarithm is good to some 1e-12; Newton's method makes it the inverse of eye_pressure.
    for (int i = 0; i < 2; ++i) {
        volume -= (eye_pressure(model, volume) - pressure) / eye_stiffness(model, volume);
    }
    return volume;
}

double tube_pressure(const ChamberModel& model, double tube_volume) { return tube_volume / model.tube_compliance; }

double bottle_pressure(const ChamberModel& model, double bottle_height) {
    return model.fluid_density * gravity * bottle_height;
}

double depth_change(const ChamberModel& model, double volume) {
    return (volume - eye_volume(model, model.rest_pressure)) / model.area;
}

double diaphragm_shift(const ChamberModel& model, double volume, double hole_area) {
    const double given_way = hole_area / (hole_area + model.half_hole_area);
    const double share = model.diaphragm_share + (1.0 - model.diaphragm_share) * given_way;
    return -share * depth_change(model, volume);
}

ChamberState chamber_state(const ChamberModel& model, double eye_pressure, double tube_pressure) {
    ChamberState state;
    state.eye_volume = eye_volume(model, eye_pressure);
    state.tube_volume = model.tube_compliance * tube_pressure;
    return state;
}

namespace {

// Heat that shrinks collagen [s].
constexpr double first_harm = 1.0;
constexpr double full_harm = 3.0;

}  // namespace

double burn_share(const WoundState& wound) {
    return std::clamp((wound.hot_s - first_harm) / (full_harm - first_harm), 0.0, 1.0);
}

WoundState burnt_wound(double burn) {
    WoundState wound;
    wound.hot_s = burn > 0.0 ? first_harm + burn * (full_harm - first_harm) : 0.0;
    return wound;
}

}  // namespace rhexis
