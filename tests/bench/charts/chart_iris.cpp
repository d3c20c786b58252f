// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "physics/anatomy/iris_prolapse.hpp"

namespace rhexis::bench {
namespace {

constexpr Samples iris_samples{0.02, 200};
constexpr double iris_wound_tunnel = 0.6;  ///< [mm]
constexpr double iris_wound_width = 2.4;   ///< [mm]
constexpr double iris_gap = 0.15;          ///< from the front of the iris to the inner lip [mm]

/// Of the eye: bottle high, lowered, high again, off [Pa].
double iris_pressure_at(double time_s) {
    if (time_s < 1.0) {
        return 45.0 * pascal_per_mmhg;
    }
    return (time_s < 2.0 || time_s > 3.0 ? 12.0 : 30.0) * pascal_per_mmhg;
}

/// Strokes over the outer lip act.
bool stroked_at(double time_s) { return (time_s > 1.4 && time_s < 1.7) || (time_s > 3.4 && time_s < 3.7); }

WorldModel iris_before_wound() {
    WorldModel model;
    model.chamber.emplace();
    model.iris.emplace();
    model.wounds.emplace();
    model.prolapse.emplace();
    Wound& wound = model.wounds->start[main_wound];
    wound.begun = wound.cut = true;
    wound.inner = Vec3(0.0, -5.0, model.iris->rest_z + 0.5 * model.iris->thickness + iris_gap);
    wound.outer = wound.inner + Vec3(0.0, -iris_wound_tunnel, 0.2);
    wound.tunnel = iris_wound_tunnel;
    wound.planes = 2;
    wound.width = iris_wound_width;
    return model;
}

Curves iris_by_kernel(double dt) {
    const WorldModel model = iris_before_wound();
    WorldState state = rest_state(model);
    return by_steps(
        iris_samples, dt,
        [&](double time_s, double step) {
            state.chamber->eye_volume = eye_volume(*model.chamber, iris_pressure_at(time_s));
            state.iris->pupil_radius = model.iris->pupil_radius;
            // one that lasts for all of this step
            state.prolapse->stroke_s = stroked_at(time_s) ? 2.0 * step : 0.0;
            move_prolapse(model, {}, step, state);
        },
        [&] { return std::vector<double>{state.prolapse->length}; });
}

/// docs/prolapse.md and docs/wounds.md: how fast a length of iris goes out or back [mm/s].
double iris_speed(double time_s, double length) {
    const double pressure = iris_pressure_at(time_s);
    const double ratio = iris_wound_tunnel / iris_wound_width / 0.7;
    const double valve = 0.15 * pressure / (20.0 * pascal_per_mmhg) * std::max(0.0, ratio - 0.5);
    const double gape = std::clamp(1.0 - ratio - valve, 0.0, 1.0);
    const double pull = pressure * (length > 0.2 ? 1.0 : gape / (1.0 + std::pow(iris_gap / 0.35, 3)));
    const double out = std::max(0.0, pull - 5.0 * pascal_per_mmhg) * 0.5 * iris_wound_width;
    const double net = out - 2000.0 * length;
    const double friction = std::min(1.0, length / 0.5) * (stroked_at(time_s) ? 150.0 : 1500.0);
    return std::copysign(std::max(0.0, std::abs(net) - friction), net) / 1500.0;
}

Equations iris_equations() {
    return {[](double time_s, const std::vector<double>& state, std::vector<double>& rate) {
                rate[0] = iris_speed(time_s, state[0]);
            },
            {0.0},
            [](const std::vector<double>& state) { return state; }};
}

std::vector<ChartPoint> measure_iris(const ChartOptions& options) {
    const Equations equations = iris_equations();
    const std::vector<double> steps{0.02, 0.01, 0.005, 0.002, 0.001};
    return points_of(
        {{"implicit (kernel)", steps, iris_by_kernel, 0.01},
         {"explicit Euler", steps, [&](double dt) { return by_explicit_euler(equations, iris_samples, dt); }},
         {"Runge-Kutta 4", steps, [&](double dt) { return by_runge_kutta(equations, iris_samples, dt); }}},
        integrated(equations, iris_samples), iris_samples.apart * iris_samples.count, options);
}

}  // namespace

Chart chart_iris() {
    return {"iris",
            "Iris driven into a short wound by 45 and 30 mmHg, held there by friction, stroked back",
            cpu_per_second,
            "length of iris in the wound, rms, share of the most",
            "the equations of docs/prolapse.md by Boost.Odeint (Dormand-Prince, 1e-10) [Ahnert2011]",
            true,
            measure_iris};
}

}  // namespace rhexis::bench
