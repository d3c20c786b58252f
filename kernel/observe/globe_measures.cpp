// SPDX-License-Identifier: GPL-3.0-or-later
// How the shafts in the wounds roll the globe and stretch the cornea.
#include <algorithm>
#include <numbers>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

class GlobeMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"globe.rotation_deg", "degrees", "Roll of the globe from how it lies at rest."});
        schema.push_back({"globe.excursion_mm", "mm",
                          "Distance of a shaft from where the middle of its wound lies at rest; the largest."});
        schema.push_back({"globe.corneal_deflection_mm", "mm", "Of the cornea beside a wound; the largest."});
        schema.push_back({"globe.enlargement_mm", "mm", "By which a wound was stretched so far; the largest."});
    }

    void measure(const ObserveInput& input, const LensView&, std::span<double>,
                 std::span<double> values) const override {
        const GlobeState& globe = *input.state.globe;
        values[0] = roll_angle(globe) * 180.0 / std::numbers::pi;
        values[1] = values[2] = values[3] = 0.0;
        for (const Lip& lip : globe.lips) {
            values[1] = std::max(values[1], lip.excursion);
            values[2] = std::max(values[2], lip.deflection.norm());
            values[3] = std::max(values[3], lip.enlargement);
        }
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> globe_measures() { return std::make_unique<GlobeMeasures>(); }

}  // namespace rhexis
