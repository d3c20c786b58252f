// SPDX-License-Identifier: GPL-3.0-or-later
// Vitreous in front of the capsule and in the wound, what pulls on it, and the viscoelastic before its openings.
#include <algorithm>
#include <numbers>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double settles_s = 1.0;  ///< after which a fresh hole has the area that its growth is counted from [s]

/// Memory. first_area: of the hole when it had settled [mm^2]; uncut_s: with vitreous in a mouth that does not cut.
enum Memory : std::size_t { open_s, first_area, uncut_s, memory_count };

double hole_growth(const ObserveInput& input, std::span<double> memory) {
    const double radius = input.state.capsule->hole_radius;
    const double area = std::numbers::pi * radius * radius;
    const bool at_start = input.state.time_s == 0.0;
    if (radius > 0.0 && (at_start || memory[open_s] < settles_s)) {
        memory[open_s] = at_start ? settles_s : memory[open_s] + input.dt;
        memory[first_area] = area;
    }
    return memory[first_area] > 0.0 ? area / memory[first_area] - 1.0 : 0.0;
}

class VitreousMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"vitreous.hyaloid_broken", "bool", "The hyaloid is broken: vitreous can come forward."});
        schema.push_back({"vitreous.front_mm3", "mm^3", "Vitreous in the anterior chamber."});
        schema.push_back({"vitreous.wound_mm3", "mm^3", "Vitreous in the main wound."});
        schema.push_back({"vitreous.marked_share", "1", "Share of it that triamcinolone shows."});
        schema.push_back({"vitreous.behind_mmhg", "mmHg", "Pressure of the vitreous."});
        schema.push_back({"vitreous.drive_mmhg", "mmHg", "What presses it against the edge of the hole now."});
        schema.push_back({"vitreous.traction_mN", "mN", "Pull on it by a mouth that holds it."});
        schema.push_back({"vitreous.peak_traction_mN", "mN", "The greatest so far."});
        schema.push_back({"vitreous.held", "bool", "It lies in a mouth that sucks."});
        schema.push_back({"vitreous.uncut_s", "s", "Time so far in which it lay in one that did not cut."});
        schema.push_back({"vitreous.cut_mm3", "mm^3", "Cut and taken away so far."});
        schema.push_back(
            {"vitreous.checked_ml", "ml", "Triamcinolone given since vitreous last came forward or was cut."});
        schema.push_back({"tamponade.fill", "1", "Share of the anterior chamber that viscoelastic fills."});
        schema.push_back({"tamponade.cover", "1", "Share of the hole that viscoelastic lies over; 1: there is none."});
        schema.push_back({"tamponade.given_ml", "ml", "Viscoelastic given so far."});
        schema.push_back({"capsule.hole_growth", "1", "Growth of the hole's area, share of what it was at first."});
        schema.push_back({"capsule.hole_x_mm", "mm", "Place of the hole in the bag, to the surgeon's right."});
        schema.push_back({"capsule.hole_y_mm", "mm", "Place of the hole in the bag, away from the surgeon."});
    }
    [[nodiscard]] std::size_t memory_size() const override { return memory_count; }

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        const VitreousModel& model = *input.world.vitreous;
        const VitreousState& vitreous = *input.state.vitreous;
        const CapsuleState& capsule = *input.state.capsule;
        const double area = std::numbers::pi * capsule.hole_radius * capsule.hole_radius;
        const bool held = vitreous.tool >= 0;
        const bool cut = held && input.world.tools[static_cast<std::size_t>(vitreous.tool)].kind == ToolKind::cutter &&
                         input.tools[static_cast<std::size_t>(vitreous.tool)].power > 0.0;
        memory[uncut_s] += held && !cut ? input.dt : 0.0;
        std::size_t next = 0;
        for (const double value :
             {vitreous.broken ? 1.0 : 0.0, vitreous_in_front(vitreous), vitreous.wound, vitreous.marked,
              vitreous.behind / pascal_per_mmhg, vitreous.drive / pascal_per_mmhg, 1e-3 * vitreous.traction,
              1e-3 * vitreous.peak_traction, held ? 1.0 : 0.0, memory[uncut_s], vitreous.cut, 1e-3 * vitreous.checked,
              filled_share(model, vitreous), covered_share(model, vitreous.plug[capsule_hole], area),
              1e-3 * vitreous.given, hole_growth(input, memory), capsule.hole_place.x(), capsule.hole_place.y()}) {
            values[next++] = value;
        }
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> vitreous_measures() { return std::make_unique<VitreousMeasures>(); }

}  // namespace rhexis
