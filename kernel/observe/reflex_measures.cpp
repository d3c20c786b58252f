// SPDX-License-Identifier: GPL-3.0-or-later
// Brightness of the red reflex over the pupil and around the first instrument's tip.
#include <limits>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

class ReflexMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"reflex.mean", "1", "Brightness of the red reflex over the pupil, 0 dark to 1."});
        schema.push_back({"reflex.tip", "1", "Its brightness around the tip of the first instrument."});
    }

    void measure(const ObserveInput& input, const LensView& lens, std::span<double>,
                 std::span<double> values) const override {
        values[0] = lens.reflex->mean_brightness;
        values[1] = std::numeric_limits<double>::quiet_NaN();
        if (!input.tools.empty() && input.tools[0].present) {
            values[1] = reflex_around(*lens.reflex, *lens.grid, *lens.fill, *lens.motion,
                                      input.eye.anatomy.pupil_radius, input.tools[0].pose.position, reflex_at_tip_mm);
        }
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> reflex_measures() { return std::make_unique<ReflexMeasures>(); }

}  // namespace rhexis
