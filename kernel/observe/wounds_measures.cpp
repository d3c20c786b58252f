// SPDX-License-Identifier: GPL-3.0-or-later
// How the wounds of the eye are made, and how well they are shut.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double usual_pressure = 20.0 * pascal_per_mmhg;  ///< at which wounds are compared [Pa]
constexpr double usual_press = 2.8e5;                      ///< an ounce on the outer lip [uN]

/// Memory. last_checked: the wounds had been tested in the last step; checks: how often so far.
enum Memory : std::size_t { last_checked, checks, memory_count };

void describe_wound(const std::string& own, const std::string& which, ObservationSchema& schema) {
    schema.push_back({own + "cut", "bool", which + " goes through into the chamber."});
    schema.push_back({own + "tunnel_mm", "mm", "Length of its way through the cornea; 0: it is not begun."});
    schema.push_back({own + "width_mm", "mm", "Its width, as far as it is cut through."});
    schema.push_back({own + "planes", "1", "Planes of its tunnel: 1, and its changes of direction."});
    schema.push_back({own + "inner_lip_mm", "mm", "Distance of its inner lip from the limbus; 0: not cut."});
    schema.push_back({own + "leak_ul_s", "ul/s", "What comes through it now."});
    schema.push_back({own + "leak_at_20_ul_s", "ul/s", "What would come through it at 20 mmHg, nothing being in it."});
    schema.push_back({own + "leak_pressed_ul_s", "ul/s", "The same, with 0.28 N on its outer lip."});
    schema.push_back({own + "peel_mm", "mm", "Descemet's membrane that hangs off at its inner lip."});
    schema.push_back({own + "sutures", "1", "Stitches that hold it."});
    schema.push_back({own + "swelling", "1", "Swelling of the stroma beside it: 0 none, 1 white and tight."});
}

double at_20(const ObserveInput& input, std::size_t which, double press) {
    const double burn = which == main_wound ? burn_share(input.state.chamber->wound) : 0.0;
    const Wound& wound = input.state.wounds->wounds[which];
    return usual_pressure * wound_conductance(*input.world.wounds, wound, burn, usual_pressure, press);
}

/// Between two places around the axis [degrees].
double angle_between(const Vec3& a, const Vec3& b) {
    const Vec2 one = a.head<2>();
    const Vec2 other = b.head<2>();
    return 180.0 / std::numbers::pi * std::abs(std::atan2(one.x() * other.y() - one.y() * other.x(), one.dot(other)));
}

class WoundsMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        describe_wound("wounds.main_", "The main wound", schema);
        describe_wound("wounds.side_", "The side port", schema);
        schema.push_back({"wounds.side_angle_deg", "degrees",
                          "Angle of the side port from the main wound; 0: not "
                          "both are there."});
        schema.push_back({"wounds.main_x_mm", "mm", "Its outer lip, to the surgeon's right of the eye's axis."});
        schema.push_back({"wounds.main_y_mm", "mm", "Its outer lip, away from the surgeon."});
        schema.push_back({"wounds.main_most_peel_mm", "mm", "The most that hung off at its inner lip so far."});
        schema.push_back({"wounds.distortion_d", "dioptres", "Astigmatism by the stitches."});
        schema.push_back({"wounds.leak_ul_s", "ul/s", "What comes through all wounds now."});
        schema.push_back({"wounds.leak_at_20_ul_s", "ul/s", "What would come through all at 20 mmHg."});
        schema.push_back({"wounds.leak_pressed_ul_s", "ul/s", "The same, with 0.28 N on each outer lip."});
        schema.push_back({"wounds.old_cut", "bool", "There is a main wound that was left for a new one."});
        schema.push_back(
            {"wounds.old_angle_deg", "degrees", "Angle between it and the new one; 0: not both are there."});
        schema.push_back({"wounds.touches", "1", "Touches of iris or lens by a blade so far."});
        schema.push_back({"wounds.press_mN", "mN", "Force on the outer lip of the main wound now."});
        schema.push_back({"wounds.peak_press_mN", "mN", "The greatest so far, on any."});
        schema.push_back({"wounds.checked", "bool", "The main wound was tested since the wounds were last changed."});
        schema.push_back({"wounds.checks", "1", "Tests of it so far."});
        schema.push_back({"wounds.tested_leak_ul_s", "ul/s", "What came meanwhile in the last test, at most."});
        schema.push_back({"wounds.injected_ml", "ml", "Given into the chamber so far."});
        schema.push_back(
            {"suprachoroidal.pressure_mmhg", "mmHg", "Pressure of bleeding that an instructor has asked for."});
        schema.push_back({"suprachoroidal.blood_mm3", "mm^3", "Blood behind the choroid."});
    }
    [[nodiscard]] std::size_t memory_size() const override { return memory_count; }

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        const WoundsState& state = *input.state.wounds;
        std::size_t next = 0;
        for (const std::size_t which : {static_cast<std::size_t>(main_wound), static_cast<std::size_t>(side_port)}) {
            next = measure_wound(input, which, values, next);
        }
        memory[checks] += state.checked && memory[last_checked] == 0.0 ? 1.0 : 0.0;
        memory[last_checked] = state.checked ? 1.0 : 0.0;
        const Wound& main = state.wounds[main_wound];
        const Wound& side = state.wounds[side_port];
        const Wound& old = state.wounds[old_wound];
        double leak = 0.0;
        double usual = 0.0;
        double pressed = 0.0;
        double distortion = 0.0;
        for (std::size_t i = 0; i < wound_count; ++i) {
            leak += state.wounds[i].leak;
            usual += at_20(input, i, 0.0);
            pressed += at_20(input, i, usual_press);
            distortion += state.wounds[i].distortion;
        }
        for (const double value :
             {main.cut && side.cut ? angle_between(main.inner, side.inner) : 0.0, main.outer.x(), main.outer.y(),
              main.most_peel, distortion, leak, usual, pressed, old.cut ? 1.0 : 0.0,
              main.cut && old.cut ? angle_between(main.inner, old.inner) : 0.0, static_cast<double>(state.touches),
              1e-3 * main.press, 1e-3 * state.peak_press, memory[last_checked], memory[checks], state.tested_leak,
              1e-3 * state.injected, state.source / pascal_per_mmhg, state.behind}) {
            values[next++] = value;
        }
    }

private:
    static std::size_t measure_wound(const ObserveInput& input, std::size_t which, std::span<double> values,
                                     std::size_t next) {
        const Wound& wound = input.state.wounds->wounds[which];
        const double cut = wound.cut ? 1.0 : 0.0;
        for (const double value :
             {cut, wound.begun ? wound.tunnel : 0.0, cut * wound.width,
              static_cast<double>(wound.begun ? wound.planes : 0),
              wound.cut ? inset_of(*input.world.wounds, wound.inner) : 0.0, wound.leak, at_20(input, which, 0.0),
              at_20(input, which, usual_press), wound.peel, static_cast<double>(wound.sutures), wound.swelling}) {
            values[next++] = value;
        }
        return next;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> wounds_measures() { return std::make_unique<WoundsMeasures>(); }

}  // namespace rhexis
