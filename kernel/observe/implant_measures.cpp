// SPDX-License-Identifier: GPL-3.0-or-later
// How an implant lies: by itself, in its bag, under the cornea.
#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "observe/distances.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double has_front = 0.3;  ///< so far unfolded, the optic's front looks somewhere

double truth(bool value) { return value ? 1.0 : 0.0; }

double angle(const Vec3& a, const Vec3& b) { return degrees * std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }

double off_axis(const Vec3& place, const Vec3& centre, const Vec3& axis) {
    const Vec3 arm = place - centre;
    return (arm - arm.dot(axis) * axis).norm();
}

class ImplantMeasures : public MeasureGroup {
public:
    ImplantMeasures(int injector, int bag, bool cornea) : injector_(injector), bag_(bag), cornea_(cornea) {}

    void describe(ObservationSchema& schema) const override;
    void measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                 std::span<double> values) const override;

private:
    [[nodiscard]] const Cartridge* cartridge(const ObserveInput& input) const {
        return injector_ < 0 ? nullptr : &*input.world.tools[at(injector_)].cartridge;
    }
    [[nodiscard]] double cornea_gap(const ObserveInput& input, const std::vector<double>& half_thickness) const;

    int injector_;
    int bag_;
    bool cornea_;
};

void ImplantMeasures::describe(ObservationSchema& schema) const {
    schema.push_back({"implant.released", "bool", "Nothing of the implant is in the injector any more."});
    schema.push_back(
        {"implant.unfolded", "1", "Largest area that the optic shadows, over its area: 0 rolled up, 1 flat."});
    schema.push_back({"implant.upside_down", "bool", "The front of the implant's optic looks to the back of the eye."});
    schema.push_back(
        {"implant.tilt_deg", "deg",
         "Angle of the optic with the bag's equator, or with the eye's axis where there is no bag. Nothing "
         "until it is released."});
    schema.push_back(
        {"implant.decentration_mm", "mm",
         "Distance of the optic's middle from the bag's axis, or the eye's. Nothing until it is released."});
    schema.push_back({"implant.haptics_on_optic", "1", "Haptics whose arm touches the optic."});
    if (bag_ >= 0) {
        schema.push_back({"implant.haptic_leading_in_bag", "bool",
                          "The end of the haptic that leaves the injector first is in the bag, behind its opening."});
        schema.push_back({"implant.haptic_trailing_in_bag", "bool", "The same of the other haptic."});
        schema.push_back({"implant.haptics_in_bag", "1", "Haptics whose ends are in the bag."});
    }
    if (cornea_) {
        schema.push_back({"implant.cornea_mm", "mm",
                          "Least distance of the implant from the back of the cornea; negative: in it. Nothing while "
                          "all of it is in the injector."});
    }
}

/// Of what is out of the injector.
double ImplantMeasures::cornea_gap(const ObserveInput& input, const std::vector<double>& half_thickness) const {
    const ShellState& implant = input.state.shells[0];
    const ToolState* tool = injector_ < 0 ? nullptr : &input.tools[at(injector_)];
    double least = HUGE_VAL;
    for (std::size_t n = 0; n < implant.position.size() && !implant.loaded; ++n) {
        const bool inside = tool != nullptr && tool->present && in_bore(*cartridge(input), *tool, implant.position[n]);
        if (!inside) {
            least = std::min(least, endothelium_distance(input.eye.anatomy, implant.position[n]) - half_thickness[n]);
        }
    }
    return least < HUGE_VAL ? least : not_defined;
}

void ImplantMeasures::measure(const ObserveInput& input, const LensView& lens, std::span<double>,
                              std::span<double> values) const {
    const ImplantPlace& place = *lens.implant;
    const ShellState& state = input.state.shells[0];
    const BagPlace nowhere;
    const BagPlace& bag = bag_ >= 0 ? *lens.soft_bag : nowhere;
    const bool released =
        injector_ < 0 ? !state.loaded : !is_in_cartridge(state, *cartridge(input), input.tools[at(injector_)]);
    std::size_t next = 0;
    values[next++] = truth(released);
    values[next++] = state.loaded ? 0.0 : place.unfolded;
    values[next++] = truth(!state.loaded && place.unfolded > has_front && place.normal.dot(bag.axis) < 0.0);
    values[next++] = released ? angle(place.normal, bag.axis) : not_defined;
    values[next++] = released ? off_axis(place.centre, bag.centre, bag.axis) : not_defined;
    values[next++] = truth(place.on_optic[0]) + truth(place.on_optic[1]);
    if (bag_ >= 0) {
        const auto in_bag = [&](const Vec3& tip) {
            return !state.loaded && lens.bag_gauge->holds(input.state.membranes[at(bag_)], tip);
        };
        const bool leading = in_bag(place.tip[0]);
        const bool trailing = in_bag(place.tip[1]);
        values[next++] = truth(leading);
        values[next++] = truth(trailing);
        values[next++] = truth(leading) + truth(trailing);
    }
    if (cornea_) {
        values[next++] = cornea_gap(input, place.half_thickness);
    }
}

}  // namespace

std::unique_ptr<MeasureGroup> implant_measures(int injector, int bag, bool cornea) {
    return std::make_unique<ImplantMeasures>(injector, bag, cornea);
}

}  // namespace rhexis
