// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/charts/equations.hpp"
#include "bench/timing.hpp"

#include <algorithm>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>

namespace rhexis::bench {
namespace {

using StateNumbers = std::vector<double>;

constexpr double odeint_tolerance = 1e-10;

void append_sample(const StateNumbers& values, Curves& curves) {
    curves.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        curves[i].push_back(values[i]);
    }
}

/// state += share * rate.
void add_rate(double share, const StateNumbers& rate, StateNumbers& state) {
    for (std::size_t i = 0; i < state.size(); ++i) {
        state[i] += share * rate[i];
    }
}

Curves equations_in_steps(const Equations& equations, const Samples& samples, double dt,
                          const std::function<void(double, StateNumbers&)>& step) {
    StateNumbers state = equations.start;
    return by_steps(
        samples, dt, [&](double time, double) { step(time, state); }, [&] { return equations.looked_at(state); });
}

}  // namespace

Curves integrated(const Equations& equations, const Samples& samples) {
    namespace odeint = boost::numeric::odeint;
    const auto stepper =
        odeint::make_controlled(odeint_tolerance, odeint_tolerance, odeint::runge_kutta_dopri5<StateNumbers>());
    StateNumbers state = equations.start;
    Curves curves;
    for (int i = 0; i < samples.count; ++i) {
        const double middle = (i + 0.5) * samples.apart;
        const auto rate = [&](const StateNumbers& at, StateNumbers& change, double) {
            equations.rate(middle, at, change);
        };
        odeint::integrate_adaptive(stepper, rate, state, 0.0, samples.apart, 0.01 * samples.apart);
        append_sample(equations.looked_at(state), curves);
    }
    return curves;
}

Curves by_explicit_euler(const Equations& equations, const Samples& samples, double dt) {
    StateNumbers rate(equations.start.size());
    return equations_in_steps(equations, samples, dt, [&](double time, StateNumbers& state) {
        equations.rate(time, state, rate);
        add_rate(dt, rate, state);
    });
}

Curves by_runge_kutta(const Equations& equations, const Samples& samples, double dt) {
    std::vector<StateNumbers> rates(4, StateNumbers(equations.start.size()));
    StateNumbers at;
    return equations_in_steps(equations, samples, dt, [&](double time, StateNumbers& state) {
        equations.rate(time, state, rates[0]);
        for (std::size_t stage = 1; stage < 4; ++stage) {
            at = state;
            add_rate(stage < 3 ? 0.5 * dt : dt, rates[stage - 1], at);
            equations.rate(time, at, rates[stage]);
        }
        for (std::size_t stage = 0; stage < 4; ++stage) {
            add_rate((stage == 0 || stage == 3 ? 1.0 : 2.0) * dt / 6.0, rates[stage], state);
        }
    });
}

Curves by_steps(const Samples& samples, double dt, const std::function<void(double, double)>& advance,
                const std::function<std::vector<double>()>& looked_at) {
    const int each = std::max(1, static_cast<int>(std::lround(samples.apart / dt)));
    Curves curves;
    for (int i = 0; i < samples.count * each; ++i) {
        advance((i + 0.5) * dt, dt);
        if ((i + 1) % each == 0) {
            append_sample(looked_at(), curves);
        }
    }
    return curves;
}

double error_of(const Curves& found, const Curves& answer) {
    double sum = 0.0;
    for (std::size_t i = 0; i < answer.size(); ++i) {
        const double share = i < found.size() ? rms_share(found[i], answer[i]) : 1.0;
        sum += share * share;
    }
    return std::sqrt(sum / static_cast<double>(answer.size()));
}

std::vector<ChartPoint> points_of(const std::vector<Way>& ways, const Curves& answer, double seconds,
                                  const ChartOptions& options) {
    std::vector<ChartPoint> points;
    for (const Way& way : ways) {
        for (const double dt : way.steps) {
            const bool is_default = dt == way.default_step;
            if (!options.only_default || is_default) {
                points.push_back(
                    point_of(way.name, milliseconds(dt), is_default, error_of(way.run(dt), answer),
                             time_interleaved({[&] { way.run(dt); }}, options.repeats)[0].seconds / seconds));
            }
        }
    }
    return points;
}

TankRates tank_rates(const ChamberModel& model, const ChamberControl& control, double eye, double tube, double given) {
    constexpr double usual = 50.0 * pascal_per_mmhg;  // at which the eye's compliance is given
    TankRates rates;
    const double bottle = bottle_pressure(model, control.bottle_height);
    rates.infusion = control.irrigation ? (bottle - eye) / model.infusion_resistance : 0.0;
    if (control.tip_open > 0.0) {
        rates.tip = (eye - tube) / (model.tube_resistance + model.tip_resistance / control.tip_open);
    }
    rates.leak = control.wound_open * model.leak_conductance * std::max(eye, 0.0);
    const double vented = control.vent ? std::max(-tube, 0.0) / model.vent_resistance : 0.0;
    const double pumped = control.pump_flow * std::clamp((control.vacuum_limit + tube) / model.pump_band, 0.0, 1.0);
    const double pressed = std::max(eye, model.collapse_pressure);
    const double stiffness = (1.0 + model.eye_stiffening * (pressed / usual - 1.0)) / model.eye_compliance;
    rates.eye = stiffness * (given + rates.infusion - rates.tip - rates.leak);
    rates.tube = (rates.tip + vented - pumped) / model.tube_compliance;
    return rates;
}

}  // namespace rhexis::bench
