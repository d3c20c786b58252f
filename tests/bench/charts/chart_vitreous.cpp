// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>

#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "physics/anatomy/capsule_wall.hpp"
#include "physics/fluid/fluid_step.hpp"
#include "tools/ia_tip.hpp"

namespace rhexis::bench {
namespace {

constexpr Samples vitreous_samples{0.02, 60};
constexpr double tip_leaves_s = 0.1;  ///< when the tip leaves the eye, and with it the bottle
constexpr double vitreous_bottle_mm = 650.0;
constexpr double vitreous_hole_mm = 0.7;  ///< radius of the hole in the posterior capsule
constexpr double backed_mm_s = 0.4;       ///< of a tear's edge that vitreous lies against, as in exercises

CapsuleModel holed_capsule() {
    CapsuleModel capsule;
    capsule.start_hole = vitreous_hole_mm;
    capsule.start_hole_place = Vec3(0.0, 0.0, -BagShape{}.posterior);
    capsule.tear_speed = backed_mm_s;
    return capsule;
}

VitreousModel broken_hyaloid() {
    VitreousModel vitreous;
    vitreous.hyaloid_strength = 0.0;
    return vitreous;
}

double pressure_before(const ChamberModel& model) {
    return bottle_pressure(model, vitreous_bottle_mm) / (1.0 + model.infusion_resistance * model.leak_conductance);
}

/// The kernel's.
class VitreousScene {
public:
    VitreousScene() {
        model_.bags.emplace_back();
        model_.chamber.emplace();
        model_.capsule = holed_capsule();
        model_.vitreous = broken_hyaloid();
        model_.tools = {ia_tip()};
        state_ = rest_state(model_);
        state_.chamber = chamber_state(*model_.chamber, pressure_before(*model_.chamber), 0.0);
        state_.vitreous->behind = pressure_before(*model_.chamber);
        tools_.resize(1);
        tools_[0].irrigation = true;
        tools_[0].bottle_height = vitreous_bottle_mm;
        tools_[0].pose.position = Vec3(0.0, 0.0, 2.5);
        probes_.push_back(mouth_probe(model_.tools[0]));
    }

    void advance(double time_s, double dt) {
        tools_[0].present = time_s < tip_leaves_s;
        step_fluid(model_, tools_, probes_, dt, state_);
        strain_capsule(model_, tools_, probes_, dt, state_);
    }

    [[nodiscard]] std::vector<double> looked_at() const {
        const double radius = state_.capsule->hole_radius;
        return {vitreous_in_front(*state_.vitreous) + state_.vitreous->wound, radius * radius};
    }

private:
    WorldModel model_;
    WorldState state_;
    std::vector<ToolState> tools_;
    std::vector<MouthProbe> probes_;
};

Curves vitreous_by_kernel(double dt) {
    VitreousScene scene;
    return by_steps(
        vitreous_samples, dt, [&](double time_s, double step) { scene.advance(time_s, step); },
        [&] { return scene.looked_at(); });
}

/// Pressures of eye, tubing and vitreous, vitreous in front and in the wound, radius of the hole.
enum VitreousPlace : std::size_t { vit_eye, vit_tube, vit_behind, vit_front, vit_wound, vit_hole, vit_places };

/// docs/vitreous.md, docs/capsule.md and docs/chamber.md.
Equations vitreous_equations() {
    const ChamberModel chamber;
    const CapsuleModel capsule = holed_capsule();
    const VitreousModel own = broken_hyaloid();
    const BagShape bag;
    const auto rate = [=](double time_s, const std::vector<double>& state, std::vector<double>& change) {
        const bool gapes = time_s > tip_leaves_s && time_s < tip_leaves_s + own.gape_s;
        ChamberControl control;
        control.irrigation = time_s < tip_leaves_s;
        control.vent = true;
        control.bottle_height = vitreous_bottle_mm;
        control.tip_open = 0.0;
        control.wound_open = gapes ? own.gape : (time_s < tip_leaves_s ? 1.0 : 0.0);
        const TankRates tanks = tank_rates(chamber, control, state[vit_eye], state[vit_tube]);
        const double drive = std::max(0.0, state[vit_behind] - state[vit_eye]);
        const double area = std::numbers::pi * state[vit_hole] * state[vit_hole];
        const double front = state[vit_front];
        const double along = gapes ? tanks.leak * front / (front + 100.0) : 0.0;
        const double tension = 0.5 * drive * bag.radius * bag.radius / bag.posterior;
        const double energy =
            tension * tension * std::numbers::pi * state[vit_hole] / (capsule.membrane_stiffness * capsule.thickness);
        change[vit_eye] = tanks.eye;
        change[vit_tube] = tanks.tube;
        change[vit_behind] = (state[vit_eye] + own.push - state[vit_behind]) / own.lag;
        change[vit_front] = own.mobility * area * drive - along;
        change[vit_wound] = along;
        change[vit_hole] = capsule.tear_speed * std::clamp(energy / capsule.tear_energy - 1.0, 0.0, 3.0);
    };
    const double before = pressure_before(chamber);
    return {rate, {before, 0.0, before, 0.0, 0.0, vitreous_hole_mm}, [](const std::vector<double>& state) {
                return std::vector<double>{state[vit_front] + state[vit_wound], state[vit_hole] * state[vit_hole]};
            }};
}

std::vector<ChartPoint> measure_vitreous(const ChartOptions& options) {
    const Equations equations = vitreous_equations();
    const std::vector<double> steps{0.02, 0.01, 0.005, 0.002, 0.001};
    return points_of({{"kernel (whole step of the fluid)", steps, vitreous_by_kernel, 0.01},
                      {"explicit Euler (equations alone)", steps,
                       [&](double dt) { return by_explicit_euler(equations, vitreous_samples, dt); }},
                      {"Runge-Kutta 4 (equations alone)", steps,
                       [&](double dt) { return by_runge_kutta(equations, vitreous_samples, dt); }}},
                     integrated(equations, vitreous_samples), vitreous_samples.apart * vitreous_samples.count, options);
}

}  // namespace

Chart chart_vitreous() {
    return {"vitreous",
            "The tip leaves an eye whose capsule has a hole of 1.4 mm",
            cpu_per_second,
            "vitreous that came forward and area of the hole, rms",
            "the equations of docs/vitreous.md by Boost.Odeint (Dormand-Prince, 1e-10) [Ahnert2011]",
            true,
            measure_vitreous};
}

}  // namespace rhexis::bench
