// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "bench/charts/models.hpp"
#include "bench/timing.hpp"
#include "physics/fluid/chamber_flow.hpp"
#include "scenes/surge.hpp"

namespace rhexis::bench {
namespace {

constexpr double occluded_s = 0.2;  ///< with the tip shut, then it opens at once
constexpr double surge_s = 0.5;
constexpr double sampled_s = 0.02;  ///< at which the pressures are compared

/// An eye that does not stiffen, in which nothing limits: the tanks are linear.
ChamberModel linear_tanks() {
    ChamberModel model;
    model.eye_stiffening = 0.0;
    return model;
}

ChamberControl control_at(double time_s) {
    ChamberControl control = scenes::aspirating({100.0, 20.0, 600.0}, time_s < occluded_s ? 0.0 : 1.0);
    return control;
}

/// d (P_eye, P_tube, 1) / dt = rate * (P_eye, P_tube, 1), from the equations in docs/chamber.md.
Eigen::Matrix3d rate_of(const ChamberModel& model, const ChamberControl& control) {
    const double in = control.irrigation ? 1.0 / model.infusion_resistance : 0.0;
    const double open = control.tip_open;
    const double tip = open > 0.0 ? 1.0 / (model.tube_resistance + model.tip_resistance / open) : 0.0;
    Eigen::Matrix3d rate = Eigen::Matrix3d::Zero();
    rate.row(0) = Eigen::RowVector3d(-(in + tip + model.leak_conductance), tip,
                                     in * bottle_pressure(model, control.bottle_height)) /
                  model.eye_compliance;
    rate.row(1) = Eigen::RowVector3d(tip, -tip, -control.pump_flow) / model.tube_compliance;
    return rate;
}

/// Pressure of the eye at every sample, by steps of dt; `advance` takes (time, dt, pressures) on by a step.
template <typename Advance>
std::vector<double> track(double dt, const Advance& advance) {
    const int each = static_cast<int>(std::lround(sampled_s / dt));
    const int steps = static_cast<int>(std::lround((occluded_s + surge_s) / dt));
    Eigen::Vector3d pressures(0.0, 0.0, 1.0);
    std::vector<double> samples;
    for (int i = 1; i <= steps; ++i) {
        advance((i - 1) * dt, dt, pressures);
        if (i % each == 0) {
            samples.push_back(pressures[0]);
        }
    }
    return samples;
}

std::vector<double> exactly() {
    return track(sampled_s, [](double time_s, double dt, Eigen::Vector3d& pressures) {
        const Eigen::Matrix3d rate = dt * rate_of(linear_tanks(), control_at(time_s));
        const Eigen::Matrix3d propagator = rate.exp();
        pressures = Eigen::Vector3d(propagator * pressures);
    });
}

std::vector<double> by_kernel(double dt) {
    const ChamberModel model = linear_tanks();
    ChamberState state = chamber_state(model, 0.0, 0.0);
    return track(dt, [&](double time_s, double step, Eigen::Vector3d& pressures) {
        advance_chamber(model, control_at(time_s), step, state);
        pressures[0] = eye_pressure(model, state.eye_volume);
    });
}

std::vector<double> by_euler(double dt, bool backward) {
    const ChamberModel model = linear_tanks();
    return track(dt, [&](double time_s, double step, Eigen::Vector3d& pressures) {
        const Eigen::Matrix3d rate = step * rate_of(model, control_at(time_s));
        if (backward) {
            pressures = Eigen::Vector3d((Eigen::Matrix3d::Identity() - rate).inverse() * pressures);
        } else {
            pressures += Eigen::Vector3d(rate * pressures);
        }
    });
}

std::vector<ChartPoint> measure(const ChartOptions& options) {
    const std::vector<double> answer = exactly();
    std::vector<ChartPoint> points;
    const auto add = [&](const char* way, double dt, bool is_default,
                         const std::function<std::vector<double>(double)>& run) {
        if (options.only_default && !is_default) {
            return;
        }
        points.push_back(
            point_of(way, milliseconds(dt), is_default, rms_share(run(dt), answer),
                     time_interleaved({[&] { run(dt); }}, options.repeats)[0].seconds / (occluded_s + surge_s)));
    };
    for (const double dt : {0.02, 0.01, 0.005, 0.002, 0.001}) {
        add("two stages, implicit (kernel)", dt, dt == 0.01, by_kernel);
    }
    for (const double dt : {0.01, 0.005, 0.002, 0.001, 0.0001}) {
        add("backward Euler", dt, false, [](double step) { return by_euler(step, true); });
    }
    for (const double dt : {0.02, 0.01, 0.005, 0.002, 0.001, 0.0001}) {
        add("explicit Euler", dt, false, [](double step) { return by_euler(step, false); });
    }
    return points;
}

}  // namespace

Chart chart_chamber() {
    return {"chamber",
            "Pressure in the eye while the tip is shut and then freed, linear tanks",
            cpu_per_second,
            "pressure, rms, share of the highest",
            "the matrix exponential of the two tanks (closed form)",
            true,
            measure};
}

}  // namespace rhexis::bench
