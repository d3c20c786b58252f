// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>

#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "physics/fluid/fluid_step.hpp"
#include "tools/rhexis_tools.hpp"

namespace rhexis::bench {
namespace {

constexpr Samples hydro_samples{0.02, 110};
const Vec3 cannula_end(3.1, 0.0, 1.2);  ///< under the rim, in the bag's frame [mm]

/// How hard the syringe is pressed: twice so that the way past the nucleus stays open, then so that it shuts.
double syringe_at(double time_s) {
    if (time_s < 0.4) {
        return 0.2;
    }
    if (time_s > 0.8 && time_s < 1.2) {
        return 0.3;
    }
    return time_s > 1.6 && time_s < 1.8 ? 1.0 : 0.0;
}

/// The kernel's: a bag that goes where the vitreous holds it, and a cannula that goes with it.
class HydroScene {
public:
    HydroScene() {
        BagModel bag;
        bag.cushion = 1.5e5;
        model_.bags.push_back(bag);
        model_.chamber.emplace();
        model_.capsule.emplace();
        model_.hydrodissection.emplace();
        model_.tools = {saline_cannula()};
        state_ = rest_state(model_);
        tools_.resize(1);
        tools_[0].present = true;
        probes_.push_back(mouth_probe(model_.tools[0]));
    }

    void advance(double time_s, double dt) {
        BagState& bag = state_.bags[0];
        tools_[0].jaw = syringe_at(time_s);
        tools_[0].pose.position = bag.pose.position + cannula_end;
        tools_[0].pose.position.z() -= forward_shift(*model_.hydrodissection, *state_.hydrodissection);
        step_fluid(model_, tools_, probes_, dt, state_);
        bag.pose.position.z() = bag.cushion_z;
    }

    [[nodiscard]] std::vector<double> looked_at() const {
        return {state_.hydrodissection->pressure, wave_share(*state_.hydrodissection)};
    }

private:
    WorldModel model_;
    WorldState state_;
    std::vector<ToolState> tools_;
    std::vector<MouthProbe> probes_;
};

Curves hydro_by_kernel(double dt) {
    HydroScene scene;
    return by_steps(
        hydro_samples, dt, [&](double time_s, double step) { scene.advance(time_s, step); },
        [&] { return scene.looked_at(); });
}

/// Pressures of eye and tubing, trapped volume, volume of the wave, viscoelastic in the chamber.
enum HydroPlace : std::size_t { hydro_eye, hydro_tube, hydro_trapped, hydro_wave, hydro_filled, hydro_places };

/// docs/bag_contents.md and docs/chamber.md.
class HydroEquations {
public:
    HydroEquations() {
        for (int cell = 0; cell < cell_count(own_.cells); ++cell) {
            ways_.push_back((cell_middle(own_.cells, cell) - cannula_end.head<2>()).norm());
        }
        std::sort(ways_.begin(), ways_.end());
        cell_ =
            own_.layer * std::numbers::pi * own_.cells.radius * own_.cells.radius / static_cast<double>(ways_.size());
    }

    void operator()(double time_s, const std::vector<double>& state, std::vector<double>& rate) const {
        const double trapped = std::max(0.0, state[hydro_trapped]);
        const double pressure = pressure_of(trapped);
        const double fill = state[hydro_filled] / own_.chamber_volume;
        const double injected = own_.injection * syringe_at(time_s) *
                                std::clamp(1.0 - (state[hydro_eye] + pressure) / own_.most_pressure, 0.0, 1.0);
        const double shut = trapped / own_.lens_area / own_.seal;
        const double way = std::clamp(1.0 - shut, own_.sealed, 1.0) * std::clamp(1.15 - fill, 0.05, 1.0);
        const double wave = room(pressure, state[hydro_wave]) ? own_.wave_flow * (pressure - own_.cleaving) : 0.0;
        ChamberControl control;
        control.vent = true;
        control.tip_open = 0.0;
        control.wound_open = own_.gape * std::clamp((state[hydro_eye] - own_.lip) / (0.5 * own_.lip), 0.0, 1.0);
        const TankRates tanks = tank_rates(chamber_, control, state[hydro_eye], state[hydro_tube], injected);
        rate[hydro_eye] = tanks.eye;
        rate[hydro_tube] = tanks.tube;
        rate[hydro_trapped] = injected - wave - own_.egress * way * pressure;
        rate[hydro_wave] = wave;
        rate[hydro_filled] = -0.5 * std::min(1.0, fill) * tanks.leak;
    }

    [[nodiscard]] Equations all() const {
        return {*this,
                {chamber_.rest_pressure, 0.0, 0.0, 0.0, own_.start_fill * own_.chamber_volume},
                [this](const std::vector<double>& state) {
                    const double all_cells = cell_ * static_cast<double>(ways_.size());
                    return std::vector<double>{pressure_of(state[hydro_trapped]), state[hydro_wave] / all_cells};
                }};
    }

private:
    [[nodiscard]] double pressure_of(double trapped) const {
        return own_.stiffness * trapped * (1.0 + trapped / own_.stiffening);
    }

    /// Whether the wave, which takes the nearest cells first, has somewhere to go.
    [[nodiscard]] bool room(double pressure, double wave) const {
        if (!(pressure > own_.cleaving)) {
            return false;
        }
        const double reach = own_.reach * (1.0 - own_.cleaving / pressure);
        const auto reached = std::lower_bound(ways_.begin(), ways_.end(), reach) - ways_.begin();
        return wave < cell_ * static_cast<double>(reached);
    }

    ChamberModel chamber_;
    HydrodissectionModel own_;
    std::vector<double> ways_;  ///< of all cells from the end of the cannula, nearest first [mm]
    double cell_ = 0.0;         ///< volume of the wave in one [mm^3]
};

std::vector<ChartPoint> measure_hydrodissection(const ChartOptions& options) {
    const HydroEquations written;
    const Equations equations = written.all();
    const std::vector<Way> ways = {
        {"kernel (whole step of the fluid)", {0.02, 0.01, 0.005, 0.002, 0.001}, hydro_by_kernel, 0.01},
        {"explicit Euler (equations alone)",
         {0.02, 0.01, 0.005, 0.002, 0.001},
         [&](double dt) { return by_explicit_euler(equations, hydro_samples, dt); }},
        {"Runge-Kutta 4 (equations alone)",
         {0.02, 0.01, 0.005, 0.002, 0.001},
         [&](double dt) { return by_runge_kutta(equations, hydro_samples, dt); }},
    };
    return points_of(ways, integrated(equations, hydro_samples), hydro_samples.apart * hydro_samples.count, options);
}

}  // namespace

Chart chart_hydrodissection() {
    return {"hydrodissection",
            "Saline under the rim: two gentle injections, then one that blocks",
            cpu_per_second,
            "pressure in the bag and share of the wave, rms",
            "the equations of docs/bag_contents.md by Boost.Odeint (Dormand-Prince, 1e-10) [Ahnert2011]",
            true,
            measure_hydrodissection};
}

}  // namespace rhexis::bench
