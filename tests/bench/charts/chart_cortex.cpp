// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "physics/fluid/fluid_step.hpp"
#include "tools/ia_tip.hpp"

namespace rhexis::bench {
namespace {

constexpr double mouth_leaves_s = 0.3;   ///< the mouth lies still in the fornix until then
constexpr double first_mouth_gap = 0.3;  ///< of the mouth from the cortex [mm]
constexpr double farthest_mouth = 1.9;   ///< [mm]
constexpr double strip_scene_s = 1.5;    ///< of each strip; the last is clean sooner

/// How one sector is stripped.
struct CortexStrip {
    double vacuum_mmhg = 0.0;
    double speed = 0.0;  ///< of the hand, away from the fornix [mm/s]
};
constexpr std::array<CortexStrip, 6> cortex_strips{{{200, 1}, {200, 2}, {300, 1}, {300, 2}, {400, 1}, {400, 2}}};

double mouth_gap_at(const CortexStrip& strip, double time_s) {
    return std::min(farthest_mouth, first_mouth_gap + strip.speed * std::max(0.0, time_s - mouth_leaves_s));
}

ChamberControl asked_of_machine(const CortexStrip& strip) {
    ChamberControl control;
    control.irrigation = true;
    control.bottle_height = 650.0;
    control.pump_flow = 25.0 * mm3_s_per_ml_min;
    control.vacuum_limit = strip.vacuum_mmhg * pascal_per_mmhg;
    return control;
}

/// Of an eye into which the bottle runs while the tip is shut [Pa].
double irrigated_pressure(const ChamberModel& model, const ChamberControl& control) {
    return bottle_pressure(model, control.bottle_height) / (1.0 + model.infusion_resistance * model.leak_conductance);
}

/// The kernel's, with a mouth that looks at the middle of the outermost cell of sector 0.
class CortexScene {
public:
    explicit CortexScene(const CortexStrip& strip) : strip_(strip) {
        model_.bags.emplace_back();
        model_.chamber.emplace();
        model_.cortex.emplace();
        model_.tools = {ia_tip()};
        state_ = rest_state(model_);
        const ChamberControl asked = asked_of_machine(strip);
        state_.chamber = chamber_state(*model_.chamber, irrigated_pressure(*model_.chamber, asked), 0.0);
        tools_.resize(1);
        tools_[0].present = tools_[0].irrigation = true;
        tools_[0].aspiration = 1.0;
        tools_[0].bottle_height = asked.bottle_height;
        tools_[0].pump_flow = asked.pump_flow;
        tools_[0].vacuum_limit = asked.vacuum_limit;
        probes_.push_back(mouth_probe(model_.tools[0]));
        cell_ = cortex_place(*model_.cortex, model_.bags[0].shape, model_.cortex->cells.rings - 1);
        outwards_ = cell_.normalized();
        tools_[0].pose.orientation = Quat::FromTwoVectors(probes_[0].mouth.facing, outwards_);
    }

    /// A step that ends then.
    void advance(double end_s, double dt) {
        ToolState& tool = tools_[0];
        const Vec3 mouth = cell_ - mouth_gap_at(strip_, end_s) * outwards_;
        tool.pose.position = mouth - tool.pose.orientation * probes_[0].mouth.centre;
        step_fluid(model_, tools_, probes_, dt, state_);
    }

    /// Nothing is left in the sector.
    [[nodiscard]] bool clean() const {
        return std::all_of(state_.cortex->volume.begin(), state_.cortex->volume.begin() + model_.cortex->cells.rings,
                           [](double volume) { return volume == 0.0; });
    }

private:
    CortexStrip strip_;
    WorldModel model_;
    WorldState state_;
    std::vector<ToolState> tools_;
    std::vector<MouthProbe> probes_;
    Vec3 cell_ = Vec3::Zero();
    Vec3 outwards_ = Vec3::Zero();
};

/// When the sector is clean, of every strip.
Curves cortex_by_kernel(double dt) {
    Curves times(1);
    for (const CortexStrip& strip : cortex_strips) {
        CortexScene scene(strip);
        double clean_s = strip_scene_s;
        for (int step = static_cast<int>(std::lround(strip_scene_s / dt)); step > 0; --step) {
            const double end_s = strip_scene_s - (step - 1) * dt;
            scene.advance(end_s, dt);
            clean_s = scene.clean() ? std::min(clean_s, end_s) : clean_s;
        }
        times[0].push_back(clean_s);
    }
    return times;
}

/// Pressures of eye and tubing, share that adheres, volume taken, time.
enum CortexPlace : std::size_t { cortex_eye, cortex_tube, cortex_adheres, cortex_taken, cortex_time, cortex_places };

/// docs/bag_contents.md and docs/chamber.md.
Equations cortex_equations(const CortexStrip& strip) {
    const ChamberModel chamber;
    const CortexModel own;
    const double area = mouth_probe(ia_tip()).area;
    const auto rate = [=](double, const std::vector<double>& state, std::vector<double>& change) {
        const bool adheres = state[cortex_adheres] > 0.0;
        ChamberControl control = asked_of_machine(strip);
        control.tip_open = adheres ? 0.05 : 0.6;
        const TankRates tanks = tank_rates(chamber, control, state[cortex_eye], state[cortex_tube]);
        const double suction = state[cortex_eye] - state[cortex_tube] - chamber.tube_resistance * tanks.tip;
        const double drawn = own.stiffness * std::max(0.0, mouth_gap_at(strip, state[cortex_time]) - own.slack);
        const double pull = suction > own.holding ? std::min(suction * area, drawn) : 0.0;
        change[cortex_eye] = tanks.eye;
        change[cortex_tube] = tanks.tube;
        change[cortex_adheres] = adheres ? -own.strip_rate * std::max(0.0, pull / own.adhesion - 1.0) : 0.0;
        change[cortex_taken] = adheres ? 0.0 : own.draw * tanks.tip;
        change[cortex_time] = 1.0;
    };
    return {rate,
            {irrigated_pressure(chamber, asked_of_machine(strip)), 0.0, 1.0, 0.0, 0.0},
            [](const std::vector<double>& state) { return std::vector<double>{state[cortex_taken]}; }};
}

/// Where the volume taken reaches that of the sector.
double time_when_clean(const std::vector<double>& taken, double apart) {
    const CortexModel own;
    const double whole = own.volume * own.cells.rings;
    for (std::size_t i = 1; i < taken.size(); ++i) {
        if (taken[i] >= whole) {
            return apart * (static_cast<double>(i) + (whole - taken[i - 1]) / (taken[i] - taken[i - 1]));
        }
    }
    return strip_scene_s;
}

Curves cortex_times(double apart, const std::function<Curves(const Equations&, const Samples&)>& run) {
    Curves times(1);
    for (const CortexStrip& strip : cortex_strips) {
        const Samples samples{apart, static_cast<int>(std::lround(strip_scene_s / apart))};
        times[0].push_back(time_when_clean(run(cortex_equations(strip), samples)[0], apart));
    }
    return times;
}

std::vector<ChartPoint> measure_cortex(const ChartOptions& options) {
    const Curves answer = cortex_times(0.001, integrated);
    const std::vector<double> steps{0.02, 0.01, 0.005, 0.002, 0.001};
    const auto all_at = [](Curves (*method)(const Equations&, const Samples&, double)) {
        return [method](double dt) {
            return cortex_times(
                dt, [&](const Equations& equations, const Samples& samples) { return method(equations, samples, dt); });
        };
    };
    return points_of({{"kernel (whole step of the fluid)", steps, cortex_by_kernel, 0.01},
                      {"explicit Euler (equations alone)", steps, all_at(by_explicit_euler)},
                      {"Runge-Kutta 4 (equations alone)", steps, all_at(by_runge_kutta)}},
                     answer, strip_scene_s * static_cast<double>(cortex_strips.size()), options);
}

}  // namespace

Chart chart_cortex() {
    return {"cortex",
            "Six sectors of cortex, held, stripped and taken at 200 to 400 mmHg",
            cpu_per_second,
            "time that a sector takes, rms, share of the longest",
            "the equations of docs/bag_contents.md by Boost.Odeint (Dormand-Prince, 1e-10) [Ahnert2011]",
            true,
            measure_cortex};
}

}  // namespace rhexis::bench
