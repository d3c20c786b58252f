// SPDX-License-Identifier: GPL-3.0-or-later
// For charts of models that are equations in time: those equations as their page in docs/ writes them, without the
// kernel's code, taken through time by Boost.Odeint to 1e-10, and by plain methods in the steps of an exercise.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/chart.hpp"
#include "flow/chamber.hpp"

namespace rhexis::bench {

/// What is looked at, each at every sample.
using Curves = std::vector<std::vector<double>>;

/// When: what hands and machine ask for changes at samples only [s].
struct Samples {
    double apart = 0.02;
    int count = 0;
};

struct Equations {
    /// d state / dt. time: amid the interval in which what is asked for stays the same [s].
    std::function<void(double time, const std::vector<double>& state, std::vector<double>& rate)> rate;
    std::vector<double> start;
    std::function<std::vector<double>(const std::vector<double>& state)> looked_at;
};

/// Dormand and Prince's pair of orders 5 and 4, steps chosen so that each errs by less than 1e-10 (Boost.Odeint).
Curves integrated(const Equations& equations, const Samples& samples);

Curves by_explicit_euler(const Equations& equations, const Samples& samples, double dt);
/// The classic one of order 4.
Curves by_runge_kutta(const Equations& equations, const Samples& samples, double dt);

/// By steps of the kernel. advance: one step of dt about a time, samples' or less.
Curves by_steps(const Samples& samples, double dt, const std::function<void(double time, double dt)>& advance,
                const std::function<std::vector<double>()>& looked_at);

/// Root of the mean of the squares of rms_share of each curve.
double error_of(const Curves& found, const Curves& answer);

/// A line of a chart.
struct Way {
    std::string name;
    std::vector<double> steps;             ///< [s]
    std::function<Curves(double dt)> run;  ///< the whole scene
    double default_step = 0.0;             ///< 0: not the way that exercises take
};

/// Every way at every step, per second of a scene of so many seconds.
std::vector<ChartPoint> points_of(const std::vector<Way>& ways, const Curves& answer, double seconds,
                                  const ChartOptions& options);

/// Of the two tanks in docs/chamber.md.
struct TankRates {
    double eye = 0.0;  ///< of its pressure [Pa/s]
    double tube = 0.0;
    double infusion = 0.0;  ///< [mm^3/s]
    double tip = 0.0;
    double leak = 0.0;
};
/// eye, tube: pressures [Pa]; given: what comes into the eye besides [mm^3/s].
TankRates tank_rates(const ChamberModel& model, const ChamberControl& control, double eye, double tube,
                     double given = 0.0);

}  // namespace rhexis::bench
