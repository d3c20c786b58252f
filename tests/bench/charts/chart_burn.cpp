// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "physics/anatomy/wound_heat.hpp"

namespace rhexis::bench {
namespace {

constexpr Samples burn_samples{0.02, 400};
constexpr double burnt_from = 60.0;  ///< [degrees C]

/// What is asked for until then.
struct SleeveHeating {
    double until_s = 0.0;
    double power = 0.0;     ///< share of full
    double infusion = 0.0;  ///< [mm^3/s]
};
/// Half power with flow; the sleeve is pinched at full power; flow again.
constexpr std::array<SleeveHeating, 3> sleeve_heatings{
    {{2.0, 0.5, usual_flow}, {5.0, 1.0, 0.0}, {8.0, 0.0, usual_flow}}};

const SleeveHeating& sleeve_heating_at(double time_s) {
    return *std::find_if(sleeve_heatings.begin(), sleeve_heatings.end() - 1,
                         [&](const SleeveHeating& heating) { return time_s < heating.until_s; });
}

/// Above the coldest that it can be, and the burn.
std::vector<double> burn_looked_at(const WoundState& wound) { return {wound.temperature - 24.0, burn_share(wound)}; }

Curves burn_by_kernel(double dt) {
    WoundState wound;
    return by_steps(
        burn_samples, dt,
        [&](double time_s, double step) {
            const SleeveHeating& heating = sleeve_heating_at(time_s);
            heat_wound(heating.power, heating.infusion, step, wound);
        },
        [&] { return burn_looked_at(wound); });
}

/// docs/chamber.md: dT/dt = rate (settles - T).
struct HeatSettling {
    double rate = 0.0;
    double settles = 0.0;
};
HeatSettling settling_at(double time_s) {
    const SleeveHeating& heating = sleeve_heating_at(time_s);
    const double fluid = 4.0 * heating.infusion / usual_flow;
    const double rate = 0.1 + fluid;
    return {rate, (20.0 * heating.power + 0.1 * 34.0 + fluid * 24.0) / rate};
}

/// The exponential, and for how much of the step it lies at or above burnt_from.
void burn_exactly(double time_s, double dt, WoundState& wound) {
    const HeatSettling own = settling_at(time_s);
    const double before = wound.temperature;
    wound.temperature = own.settles + (before - own.settles) * std::exp(-own.rate * dt);
    const bool hot = before >= burnt_from;
    if (hot != (wound.temperature >= burnt_from)) {
        const double crossing = std::log((before - own.settles) / (burnt_from - own.settles)) / own.rate;
        wound.hot_s += hot ? crossing : dt - crossing;
    } else {
        wound.hot_s += hot ? dt : 0.0;
    }
}

Curves burn_by_exponential(double dt) {
    WoundState wound;
    return by_steps(
        burn_samples, dt, [&](double time_s, double step) { burn_exactly(time_s, step, wound); },
        [&] { return burn_looked_at(wound); });
}

Curves burn_by_euler(double dt) {
    WoundState wound;
    return by_steps(
        burn_samples, dt,
        [&](double time_s, double step) {
            const HeatSettling own = settling_at(time_s);
            wound.temperature += step * own.rate * (own.settles - wound.temperature);
            wound.hot_s += wound.temperature >= burnt_from ? step : 0.0;
        },
        [&] { return burn_looked_at(wound); });
}

std::vector<ChartPoint> measure_burn(const ChartOptions& options) {
    const std::vector<double> steps{0.02, 0.01, 0.005, 0.002, 0.001};
    return points_of({{"backward Euler (kernel)", steps, burn_by_kernel, 0.01},
                      {"explicit Euler", {0.01, 0.001}, burn_by_euler},
                      {"the exponential in each step", {0.02, 0.01, 0.001}, burn_by_exponential}},
                     burn_by_exponential(burn_samples.apart), burn_samples.apart * burn_samples.count, options);
}

}  // namespace

Chart chart_burn() {
    return {"burn",
            "Heat of the wound while the sleeve is pinched for 3 s under full power",
            cpu_per_second,
            "temperature and burn, rms, share of the most",
            "exponentials and the time above 60 degrees (closed form)",
            true,
            measure_burn};
}

}  // namespace rhexis::bench
