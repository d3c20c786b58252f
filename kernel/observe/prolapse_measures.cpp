// SPDX-License-Identifier: GPL-3.0-or-later
// Iris in the main wound.
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double out = 0.2;  ///< a shorter one stays within the inner lip [mm]

class ProlapseMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"iris.prolapse_mm", "mm", "Length of the iris outside the inner lip of the main wound."});
        schema.push_back({"iris.prolapse_peak_mm", "mm", "The greatest so far."});
        schema.push_back(
            {"iris.prolapse_damage", "1", "Damage by pushes on it: 0 none, 1 nothing is left that holds it."});
        schema.push_back({"iris.pushed_back_mm", "mm", "Length that was pushed back through the wound so far."});
        schema.push_back({"iris.stroked", "bool", "An instrument strokes over the outer lip."});
        schema.push_back({"iris.prolapse_state", "1", "0: none so far; 1: it is back in the eye; 2: it is out."});
        schema.push_back({"iris.pull_mmhg", "mmHg", "Pressure that drives the iris into the wound."});
    }

    void measure(const ObserveInput& input, const LensView&, std::span<double>,
                 std::span<double> values) const override {
        const ProlapseState& prolapse = *input.state.prolapse;
        values[0] = prolapse.length;
        values[1] = prolapse.most;
        values[2] = prolapse.damage;
        values[3] = prolapse.pushed;
        values[4] = prolapse.stroke_s > 0.0 ? 1.0 : 0.0;
        values[5] = prolapse.length > out ? 2.0 : prolapse.most > out ? 1.0 : 0.0;
        values[6] = prolapse.pull / pascal_per_mmhg;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> prolapse_measures() { return std::make_unique<ProlapseMeasures>(); }

}  // namespace rhexis
