// SPDX-License-Identifier: GPL-3.0-or-later
// How the microscope stands over the pupil.
#include "observe/field.hpp"
#include "observe/measure_group.hpp"
#include "observe/seen.hpp"

namespace rhexis {
namespace {

class MicroscopeMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"microscope.x_mm", "mm", "What is in the middle of the field: to the surgeon's right."});
        schema.push_back({"microscope.y_mm", "mm", "The same: away from the surgeon."});
        schema.push_back({"microscope.z_mm", "mm", "Height of the plane in focus."});
        schema.push_back({"microscope.pupil_offset", "1",
                          "Distance of the pupil's middle from that of the field, share of the field's radius."});
        schema.push_back({"microscope.pupil_in_view", "bool", "All of the pupil is in the field."});
        schema.push_back({"microscope.defocus_mm", "mm",
                          "How far over the plane of the pupil's edge the microscope is focused; negative: under it."});
        schema.push_back({"microscope.in_focus", "bool", "That plane is within the depth of field."});
    }

    void measure(const ObserveInput& input, const LensView&, std::span<double>,
                 std::span<double> values) const override {
        const MicroscopeState& state = *input.state.microscope;
        const FieldOfView field = field_of_view(*input.world.microscope, state, input.eye.anatomy, pupil_middle(input));
        values[0] = state.position.x();
        values[1] = state.position.y();
        values[2] = state.position.z();
        values[3] = field.pupil_offset / field.radius;
        values[4] = field.shows_whole_pupil() ? 1.0 : 0.0;
        values[5] = field.defocus;
        values[6] = field.out_of_focus() > 0.0 ? 0.0 : 1.0;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> microscope_measures() { return std::make_unique<MicroscopeMeasures>(); }

}  // namespace rhexis
