// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "physics/fluid/fluid_step.hpp"
#include "tools/wound_tools.hpp"

namespace rhexis::bench {
namespace {

constexpr Samples wound_samples{0.02, 220};
constexpr double wound_tunnel_mm = 1.4;
constexpr double wound_width_mm = 2.4;
constexpr double sponge_deep = 0.9;  ///< of its ball in the cornea [mm]: 0.27 N

enum class WoundClosing { watched, pressed, filled, hydrated };

/// What is done: pressed, left alone, filled through a cannula in the chamber, hydrated, pressed again.
WoundClosing closing_at(double time_s) {
    if (time_s < 0.6 || (time_s > 3.4 && time_s < 4.0)) {
        return WoundClosing::pressed;
    }
    if (time_s > 1.0 && time_s < 2.0) {
        return WoundClosing::filled;
    }
    return time_s > 2.2 && time_s < 3.2 ? WoundClosing::hydrated : WoundClosing::watched;
}

WoundsModel leaking_wound() {
    constexpr double apex_z = 4.9;
    constexpr double thickness = 0.534;
    WoundsModel wounds;
    wounds.front_centre.z() = apex_z - wounds.front_radius;
    wounds.back_centre.z() = apex_z - thickness - wounds.back_radius;
    wounds.start[main_wound] = made_wound(wounds, Vec2(0.0, -1.0), wound_tunnel_mm, wound_width_mm, 1.2);
    return wounds;
}

/// The kernel's, with a sponge and a cannula.
class WoundScene {
public:
    WoundScene() {
        model_.chamber.emplace();
        model_.wounds = leaking_wound();
        model_.tools = {sponge(), hydration_cannula()};
        state_ = rest_state(model_);
        tools_.resize(2);
        for (const ToolModel& tool : model_.tools) {
            probes_.push_back(mouth_probe(tool));
        }
        const Wound& wound = model_.wounds->start[main_wound];
        const RoundedCone& ball = model_.tools[0].parts[0];
        const Vec3 outwards = (wound.outer - model_.wounds->front_centre).normalized();
        const double from_centre = model_.wounds->front_radius + ball.radius_a - sponge_deep;
        tools_[0].pose.position = model_.wounds->front_centre + from_centre * outwards - ball.a;
    }

    void advance(double time_s, double dt) {
        const WoundClosing now = closing_at(time_s);
        const Wound& wound = model_.wounds->start[main_wound];
        tools_[0].present = now == WoundClosing::pressed;
        tools_[1].present = now == WoundClosing::filled || now == WoundClosing::hydrated;
        tools_[1].pose.position =
            now == WoundClosing::filled ? Vec3(0.5 * wound.inner) : Vec3(0.5 * (wound.outer + wound.inner));
        tools_[1].jaw = now == WoundClosing::hydrated ? 1.0 : 0.7;
        step_fluid(model_, tools_, probes_, dt, state_);
    }

    [[nodiscard]] std::vector<double> looked_at() const {
        return {eye_pressure(*model_.chamber, state_.chamber->eye_volume), state_.wounds->wounds[main_wound].fluid};
    }

private:
    WorldModel model_;
    WorldState state_;
    std::vector<ToolState> tools_;
    std::vector<MouthProbe> probes_;
};

Curves wounds_by_kernel(double dt) {
    WoundScene scene;
    return by_steps(
        wound_samples, dt, [&](double time_s, double step) { scene.advance(time_s, step); },
        [&] { return scene.looked_at(); });
}

/// Of laminar flow in a slit of this height and width, share of that between plates: the series for a rectangular
/// duct [White2006 eq. 3-48].
double duct_share(double height, double width) {
    double sum = 0.0;
    for (int n = 1; n < 20 && height > 0.0; n += 2) {
        sum += std::tanh(0.5 * n * std::numbers::pi * width / height) / std::pow(n, 5);
    }
    return 1.0 - 192.0 / std::pow(std::numbers::pi, 5) * height / width * sum;
}

/// Pressures of eye and tubing, fluid on the lip, swelling.
enum WoundsPlace : std::size_t { wet_eye, wet_tube, wet_fluid, wet_swelling, wet_places };

/// docs/wounds.md and docs/chamber.md, the slit as a duct with four walls.
class WoundEquations {
public:
    void operator()(double time_s, const std::vector<double>& state, std::vector<double>& rate) const {
        const WoundClosing now = closing_at(time_s);
        const double eye = state[wet_eye];
        const double slit =
            conductance(eye, state[wet_swelling], now == WoundClosing::pressed ? 0.3e6 * sponge_deep : 0.0);
        const double beside = now == WoundClosing::filled ? chamber_.leak_conductance : 0.0;
        const double eased = std::clamp(1.0 - eye / own_.most_pressure, 0.0, 1.0);
        const double injected = now == WoundClosing::filled ? 0.7 * own_.injection * eased : 0.0;
        ChamberControl control;
        control.vent = true;
        control.tip_open = 0.0;
        control.wound_open = (slit + beside) / chamber_.leak_conductance;
        const double aqueous = own_.outflow * (chamber_.rest_pressure - eye);
        const TankRates tanks = tank_rates(chamber_, control, eye, state[wet_tube], injected + aqueous);
        rate[wet_eye] = tanks.eye;
        rate[wet_tube] = tanks.tube;
        rate[wet_fluid] = tanks.leak - (now == WoundClosing::pressed ? 6.0 : 1.0) * state[wet_fluid];
        rate[wet_swelling] = (now == WoundClosing::hydrated ? own_.hydration * own_.tight / wound_width_mm : 0.0) -
                             state[wet_swelling] / 1800.0;
    }

    [[nodiscard]] Equations all() const {
        return {*this, {chamber_.rest_pressure, 0.0, 0.0, 0.0}, [](const std::vector<double>& state) {
                    return std::vector<double>{state[wet_eye], state[wet_fluid]};
                }};
    }

private:
    [[nodiscard]] double conductance(double eye, double swelling, double press) const {
        const double ratio = wound_tunnel_mm / wound_width_mm / 0.7;
        const double valve = 0.15 * std::max(0.0, eye) / (20.0 * pascal_per_mmhg) * std::max(0.0, ratio - 0.5);
        const double gape = 1.0 - ratio - valve - 0.6 * swelling + 0.35 * press / 0.28e6;
        const double height = 0.06 * std::clamp(gape, 0.0, 1.0);
        return duct_share(height, wound_width_mm) * wound_width_mm * height * height * height /
               (12.0 * own_.viscosity * wound_tunnel_mm);
    }

    ChamberModel chamber_;
    WoundsModel own_;
};

std::vector<ChartPoint> measure_wounds(const ChartOptions& options) {
    const Equations equations = WoundEquations().all();
    const std::vector<double> steps{0.02, 0.01, 0.005, 0.002, 0.001};
    return points_of({{"kernel (whole step of the fluid)", steps, wounds_by_kernel, 0.01},
                      {"explicit Euler (equations alone)", steps,
                       [&](double dt) { return by_explicit_euler(equations, wound_samples, dt); }},
                      {"Runge-Kutta 4 (equations alone)", steps,
                       [&](double dt) { return by_runge_kutta(equations, wound_samples, dt); }}},
                     integrated(equations, wound_samples), wound_samples.apart * wound_samples.count, options);
}

}  // namespace

Chart chart_wounds() {
    return {
        "wounds",
        "A short tunnel, pressed, filled through, hydrated and pressed again",
        cpu_per_second,
        "pressure of the eye and fluid on the lip, rms",
        "equations of docs/wounds.md, the slit a rectangular duct [White2006], by Boost.Odeint (Dormand-Prince, 1e-10)",
        true,
        measure_wounds};
}

}  // namespace rhexis::bench
