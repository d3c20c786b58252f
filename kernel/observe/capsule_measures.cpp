// SPDX-License-Identifier: GPL-3.0-or-later
// What the posterior capsule has to bear.
#include <numbers>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

class CapsuleMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"capsule.strain", "1", "Largest strain of the posterior capsule under an instrument."});
        schema.push_back({"capsule.strain_share", "1", "That strain as a share of what it bears."});
        schema.push_back({"capsule.peak_strain", "1", "The largest strain so far."});
        schema.push_back({"capsule.dimple_mm", "mm", "Depth to which an instrument pushes it; negative: draws it in."});
        schema.push_back({"capsule.force_mN", "mN", "Force of instruments on it."});
        schema.push_back({"capsule.captured", "bool", "A tip that sucks holds it: folds like a star around the tip."});
        schema.push_back({"capsule.open", "bool", "There is a hole in it."});
        schema.push_back({"capsule.hole_mm2", "mm^2", "Area of the hole."});
    }

    void measure(const ObserveInput& input, const LensView&, std::span<double>,
                 std::span<double> values) const override {
        const CapsuleState& capsule = *input.state.capsule;
        values[0] = capsule.strain;
        values[1] = capsule.strain / input.world.capsule->ultimate_strain;
        values[2] = capsule.peak_strain;
        values[3] = capsule.depth;
        values[4] = 1e-3 * capsule.force.norm();
        values[5] = capsule.captured ? 1.0 : 0.0;
        values[6] = capsule.hole_radius > 0.0 ? 1.0 : 0.0;
        values[7] = std::numbers::pi * capsule.hole_radius * capsule.hole_radius;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> capsule_measures() { return std::make_unique<CapsuleMeasures>(); }

}  // namespace rhexis
