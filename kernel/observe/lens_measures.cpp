// SPDX-License-Identifier: GPL-3.0-or-later
// How the lens as a whole has moved, and how much of it has gone.
#include <algorithm>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

enum Memory : std::size_t { last_removed_mm3, peak_displacement_mm, memory_count };

class LensMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"lens.displacement_mm", "mm", "How far the lens as a whole has been shifted."});
        schema.push_back({"lens.peak_displacement_mm", "mm", "The most it has been shifted so far."});
        schema.push_back(
            {"lens.removed_mm3", "mm^3", "Volume that has left the lens so far: emulsified, or loose as crumbs."});
        schema.push_back({"lens.removed_mg", "mg", "Mass emulsified so far."});
        schema.push_back({"lens.removal_rate_mm3_s", "mm^3/s", "Volume that leaves the lens per second now."});
        schema.push_back({"lens.ablation_mJ", "mJ", "Ultrasound energy spent in the lens so far."});
    }
    [[nodiscard]] std::size_t memory_size() const override { return memory_count; }

    void measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                 std::span<double> values) const override {
        const double removed = lens.fill->removed_volume;
        // What the fluid does to lens and iris together is no push.
        const double carried = input.state.bags.empty() ? 0.0 : input.state.bags[0].cushion_z;
        const double displacement = (lens.motion->shift - carried * Vec3::UnitZ()).norm();
        memory[peak_displacement_mm] = std::max(memory[peak_displacement_mm], displacement);
        values[0] = displacement;
        values[1] = memory[peak_displacement_mm];
        values[2] = removed;
        values[3] = input.state.removed_mass * 1e3;
        values[4] = (removed - memory[last_removed_mm3]) / input.dt;
        values[5] = input.state.ablation_energy;
        memory[last_removed_mm3] = removed;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> lens_measures() { return std::make_unique<LensMeasures>(); }

}  // namespace rhexis
