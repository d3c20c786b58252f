// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/math/special_functions/lambert_w.hpp>
#include <cmath>

#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "physics/anatomy/bag_contents.hpp"
#include "physics/fluid/viscoelastic_fill.hpp"
#include "tools/ia_tip.hpp"
#include "tools/rhexis_tools.hpp"

namespace rhexis::bench {
namespace {

constexpr Samples ovd_samples{0.02, 100};
constexpr double mouth_behind_s = 0.4;   ///< for which the mouth lies behind the implant, then in front of it
constexpr double ovd_injecting_s = 0.8;  ///< for which a syringe fills the chamber, then it leaks
constexpr double ovd_press = 0.7;        ///< of the syringe, share of full
constexpr double ovd_start_fill = 0.5;   ///< share of the chamber
constexpr double ovd_flow = 25.0 * mm3_s_per_ml_min;      ///< into the mouth
constexpr double ovd_infusion = 28.0 * mm3_s_per_ml_min;  ///< a part leaks

RetainedViscoelasticModel left_model() {
    RetainedViscoelasticModel model;
    model.start_front = 180.0;
    model.start_behind = 40.0;
    model.start_angle = 20.0;
    return model;
}

ViscoelasticModel chamber_of_viscoelastic() {
    ViscoelasticModel model;
    model.start_fill = ovd_start_fill;
    return model;
}

/// The kernel's: removal through a mouth after the implant, and the chamber that a cannula fills beside a cystotome.
class ViscoelasticScene {
public:
    ViscoelasticScene() {
        after_.bags.emplace_back();
        after_.retained = left_model();
        after_.tools = {ia_tip()};
        left_ = rest_state(after_);
        left_.flows.infusion = ovd_infusion;
        left_.tips[0].flow = ovd_flow;
        tip_.resize(1);
        tip_[0].present = true;
        tip_[0].aspiration = 1.0;
        probes_.push_back(mouth_probe(after_.tools[0]));
        before_.viscoelastic = chamber_of_viscoelastic();
        before_.tools = {viscoelastic_cannula(), cystotome()};
        filled_ = rest_state(before_);
        hands_.resize(2);
        hands_[0].present = hands_[1].present = true;
    }

    void advance(double time_s, double dt) {
        const double height = time_s < mouth_behind_s ? -1.5 : 0.5;  // of the mouth, on the axis of the bag
        tip_[0].pose.position = Vec3(0.0, 0.0, height) - probes_[0].mouth.centre;
        remove_viscoelastic(after_, tip_, probes_, dt, left_);
        hands_[0].jaw = time_s < ovd_injecting_s ? ovd_press : 0.0;
        fill_chamber(before_, hands_, dt, filled_);
    }

    [[nodiscard]] std::vector<double> looked_at() const {
        return {viscoelastic_left(*left_.retained), filled_.viscoelastic->fill};
    }

private:
    WorldModel after_;
    WorldState left_;
    std::vector<ToolState> tip_;
    std::vector<MouthProbe> probes_;
    WorldModel before_;
    WorldState filled_;
    std::vector<ToolState> hands_;
};

Curves ovd_by_kernel(double dt) {
    ViscoelasticScene scene;
    return by_steps(
        ovd_samples, dt, [&](double time_s, double step) { scene.advance(time_s, step); },
        [&] { return scene.looked_at(); });
}

enum OvdPlace : std::size_t { ovd_front, ovd_behind, ovd_angle, ovd_fill, ovd_places };

std::vector<double> ovd_looked_at(const std::vector<double>& state) {
    return {state[ovd_front] + state[ovd_behind] + state[ovd_angle], state[ovd_fill]};
}

std::vector<double> ovd_start() { return {180.0, 40.0, 20.0, ovd_start_fill}; }

/// docs/bag_contents.md and, of the fill, flow/viscoelastic.hpp.
Equations ovd_equations() {
    const RetainedViscoelasticModel own = left_model();
    const ViscoelasticModel chamber = chamber_of_viscoelastic();
    const auto rate = [=](double time_s, const std::vector<double>& state, std::vector<double>& change) {
        const auto drawn = [&](double volume) { return own.draw * ovd_flow * volume / (volume + own.whole); };
        const bool behind = time_s < mouth_behind_s;
        change[ovd_front] = -own.wash * ovd_infusion / usual_flow * state[ovd_front];
        change[ovd_front] -= behind ? 0.0 : drawn(state[ovd_front]);
        change[ovd_behind] = behind ? -drawn(state[ovd_behind]) : 0.0;
        change[ovd_angle] = behind ? 0.0 : -own.angle_draw * drawn(state[ovd_angle]);
        const double injected = time_s < ovd_injecting_s ? ovd_press * chamber.injection / chamber.volume : 0.0;
        change[ovd_fill] = injected - 2.0 * chamber.leak * state[ovd_fill];
    };
    return {rate, ovd_start(), ovd_looked_at};
}

/// dV/dt = -most V / (V + whole): V + whole ln V falls evenly, which Lambert's function turns round.
double drawn_to(double volume, double most, double whole, double time_s) {
    return whole * boost::math::lambert_w0(volume / whole * std::exp((volume - most * time_s) / whole));
}

/// The same that is washed out besides, dV/dt = -most V / (V + whole) - wash V: partial fractions, by halving.
double drawn_and_washed_to(double volume, double most, double whole, double wash, double time_s) {
    const double both = most + wash * whole;
    const auto taken_s = [&](double left) {
        return whole / both * std::log(volume / left) +
               (1.0 - wash * whole / both) / wash * std::log((both + wash * volume) / (both + wash * left));
    };
    double low = std::log(volume) - both * time_s / whole;
    double high = std::log(volume);
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (taken_s(std::exp(middle)) > time_s ? low : high) = middle;
    }
    return std::exp(0.5 * (low + high));
}

/// Of a state, after dt in which nothing that is asked for changes.
void ovd_exactly(double time_s, double dt, std::vector<double>& state) {
    const RetainedViscoelasticModel own = left_model();
    const ViscoelasticModel chamber = chamber_of_viscoelastic();
    const double most = own.draw * ovd_flow;
    const double wash = own.wash * ovd_infusion / usual_flow;
    if (time_s < mouth_behind_s) {
        state[ovd_front] *= std::exp(-wash * dt);
        state[ovd_behind] = drawn_to(state[ovd_behind], most, own.whole, dt);
    } else {
        state[ovd_front] = drawn_and_washed_to(state[ovd_front], most, own.whole, wash, dt);
        state[ovd_angle] = drawn_to(state[ovd_angle], own.angle_draw * most, own.whole, dt);
    }
    const double leak = 2.0 * chamber.leak;
    const double settles = time_s < ovd_injecting_s ? ovd_press * chamber.injection / chamber.volume / leak : 0.0;
    state[ovd_fill] = settles + (state[ovd_fill] - settles) * std::exp(-leak * dt);
}

Curves ovd_by_closed_forms(double dt) {
    std::vector<double> state = ovd_start();
    return by_steps(
        ovd_samples, dt, [&](double time_s, double step) { ovd_exactly(time_s, step, state); },
        [&] { return ovd_looked_at(state); });
}

std::vector<ChartPoint> measure_viscoelastic(const ChartOptions& options) {
    const Equations equations = ovd_equations();
    const std::vector<double> steps{0.02, 0.01, 0.005, 0.002, 0.001};
    return points_of({{"explicit Euler (kernel)", steps, ovd_by_kernel, 0.01},
                      {"Runge-Kutta 4", steps, [&](double dt) { return by_runge_kutta(equations, ovd_samples, dt); }},
                      {"closed forms in each step", {0.02, 0.01}, ovd_by_closed_forms}},
                     ovd_by_closed_forms(ovd_samples.apart), ovd_samples.apart * ovd_samples.count, options);
}

}  // namespace

Chart chart_viscoelastic() {
    return {"viscoelastic",
            "Viscoelastic taken from behind and before an implant; a chamber filled",
            cpu_per_second,
            "volume left and fill, rms, share of the most",
            "closed forms: Lambert's function [Schnell1997], partial fractions, an exponential",
            true,
            measure_viscoelastic};
}

}  // namespace rhexis::bench
