// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "physics/fluid/chamber_flow.hpp"
#include "scenes/surge.hpp"

namespace rhexis::bench {
namespace {

constexpr double surge_scene_s = 0.3;  ///< from the break; the eye is at its lowest within 0.1 s

/// What spring eyes lost to two machines with peristaltic pumps when an occlusion broke, at 20 ml/min [Miller2020].
struct SurgeBench {
    double pressure_mmhg = 0.0;  ///< that the machine is set to keep in the eye
    double vacuum_mmhg = 0.0;
    double lost = 0.0;  ///< mean of both [mm^3]
};
constexpr std::array<SurgeBench, 4> surge_benches{{{40.0, 500.0, 0.5 * (50.9 + 77.3)},
                                                   {40.0, 600.0, 0.5 * (63.6 + 112.5)},
                                                   {50.0, 500.0, 0.5 * (48.6 + 70.3)},
                                                   {50.0, 600.0, 0.5 * (61.8 + 102.6)}}};

/// A rig does not leak; what its machine keeps in the eye, the bottle does here.
ChamberControl broken_occlusion(const SurgeBench& bench) {
    ChamberControl control = scenes::aspirating({0.0, 20.0, bench.vacuum_mmhg}, 1.0);
    control.bottle_height = bench.pressure_mmhg * pascal_per_mmhg / bottle_pressure({}, 1.0);
    control.wound_open = 0.0;
    return control;
}

ChamberState occluded_eye(const ChamberModel& model, const SurgeBench& bench) {
    return chamber_state(model, bench.pressure_mmhg * pascal_per_mmhg, -bench.vacuum_mmhg * pascal_per_mmhg);
}

/// Volume that the eye gives in each, as far as its lowest pressure.
Curves surge_by_kernel(const ChamberModel& model, double dt) {
    Curves lost(1);
    for (const SurgeBench& bench : surge_benches) {
        ChamberState state = occluded_eye(model, bench);
        const double held = state.eye_volume;
        double lowest = eye_pressure(model, held);
        for (int i = 0; i < std::lround(surge_scene_s / dt); ++i) {
            lowest = std::min(lowest, advance_chamber(model, broken_occlusion(bench), dt, state).lowest_eye_pressure);
        }
        lost[0].push_back(held - eye_volume(model, lowest));
    }
    return lost;
}

/// The same, by pressures of eye and tubing [docs/chamber.md].
Curves surge_by(double apart, const std::function<Curves(const Equations&, const Samples&)>& run) {
    const ChamberModel model;
    Curves lost(1);
    for (const SurgeBench& bench : surge_benches) {
        const auto rate = [&](double, const std::vector<double>& state, std::vector<double>& change) {
            const TankRates rates = tank_rates(model, broken_occlusion(bench), state[0], state[1]);
            change = {rates.eye, rates.tube};
        };
        const Curves pressure = run({rate,
                                     {bench.pressure_mmhg * pascal_per_mmhg, -bench.vacuum_mmhg * pascal_per_mmhg},
                                     [](const std::vector<double>& state) { return std::vector<double>{state[0]}; }},
                                    {apart, static_cast<int>(std::lround(surge_scene_s / apart))});
        const double lowest = *std::min_element(pressure[0].begin(), pressure[0].end());
        lost[0].push_back(eye_volume(model, bench.pressure_mmhg * pascal_per_mmhg) - eye_volume(model, lowest));
    }
    return lost;
}

Curves measured_on_benches() {
    Curves lost(1);
    for (const SurgeBench& bench : surge_benches) {
        lost[0].push_back(bench.lost);
    }
    return lost;
}

std::vector<ChartPoint> measure_surge(const ChartOptions& options) {
    const double seconds = surge_scene_s * static_cast<double>(surge_benches.size());
    const std::vector<double> steps{0.02, 0.01, 0.005, 0.002, 0.001};
    ChamberModel linear;
    linear.eye_stiffening = 0.0;
    std::vector<ChartPoint> points =
        points_of({{"kernel, against machines", steps, [](double dt) { return surge_by_kernel({}, dt); }, 0.01},
                   {"linear eye, against machines", {0.01}, [&](double dt) { return surge_by_kernel(linear, dt); }}},
                  measured_on_benches(), seconds, options);
    if (options.only_default) {
        return points;
    }
    const std::vector<ChartPoint> written =
        points_of({{"kernel, against its equations", steps, [](double dt) { return surge_by_kernel({}, dt); }},
                   {"explicit Euler, against them", steps,
                    [](double dt) {
                        return surge_by(dt, [&](const Equations& equations, const Samples& samples) {
                            return by_explicit_euler(equations, samples, dt);
                        });
                    }}},
                  surge_by(0.0001, integrated), seconds, options);
    points.insert(points.end(), written.begin(), written.end());
    return points;
}

}  // namespace

Chart chart_surge() {
    return {"surge",
            "Volume that the eye loses when an occlusion breaks at 500 and 600 mmHg",
            cpu_per_second,
            "volume lost, rms of four settings, share of the most",
            "mean of two machines on a bench [Miller2020]; besides, the equations of docs/chamber.md by Boost.Odeint",
            true,
            measure_surge};
}

}  // namespace rhexis::bench
