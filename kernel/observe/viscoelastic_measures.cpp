// SPDX-License-Identifier: GPL-3.0-or-later
// How full of viscoelastic the anterior chamber is, and how far the lens has come forward.
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

class ViscoelasticMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"viscoelastic.fill", "1", "Share of the anterior chamber that viscoelastic fills."});
        schema.push_back({"viscoelastic.peak_fill", "1", "The greatest so far; above 1: overfilled."});
        schema.push_back({"viscoelastic.pressure_mmhg", "mmHg", "Pressure in the anterior chamber."});
        schema.push_back({"viscoelastic.injected_ml", "ml", "Viscoelastic injected so far."});
        schema.push_back({"lens.lift_mm", "mm", "How far the lens has come forward from where it rests."});
    }

    void measure(const ObserveInput& input, const LensView&, std::span<double>,
                 std::span<double> values) const override {
        const ViscoelasticState& state = *input.state.viscoelastic;
        values[0] = state.fill;
        values[1] = state.peak_fill;
        values[2] = viscoelastic_pressure(*input.world.viscoelastic, state) / pascal_per_mmhg;
        values[3] = 1e-3 * state.injected;
        values[4] = input.state.membranes.empty() ? 0.0 : input.state.membranes[0].support.lift;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> viscoelastic_measures() { return std::make_unique<ViscoelasticMeasures>(); }

}  // namespace rhexis
