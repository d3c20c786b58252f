// SPDX-License-Identifier: GPL-3.0-or-later
// The opening that is torn in the anterior capsule.
#include <algorithm>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

/// Length of the most stretched zonule over what it was at the start, less 1.
double zonule_strain(const MembraneModel& model, const MembraneState& state) {
    double most = 0.0;
    for (const NodeSpring& spring : model.springs) {
        if (spring.slack > 0.0) {
            const std::size_t node = static_cast<std::size_t>(spring.node);
            const double before = (spring.anchor - model.sheet->mesh.nodes[node]).norm();
            most = std::max(most, (spring.anchor - state.position[node]).norm() / before - 1.0);
        }
    }
    return most;
}

class RhexisMeasures : public MeasureGroup {
public:
    explicit RhexisMeasures(int membrane) : membrane_(static_cast<std::size_t>(membrane)) {}
    [[nodiscard]] std::size_t memory_size() const override { return 1; }

    void describe(ObservationSchema& schema) const override {
        schema.push_back({"rhexis.opened", "bool", "There is an opening in the anterior capsule."});
        schema.push_back({"rhexis.closed", "bool", "The tear met its beginning: the flap has come loose."});
        schema.push_back({"rhexis.run_out", "bool", "A tear has passed the ring in which the zonules insert."});
        schema.push_back({"rhexis.torn_mm", "mm", "Length of all tears of the anterior capsule."});
        schema.push_back({"rhexis.turned_deg", "deg", "Angle about the axis that the tear has gone round, 0 to 360."});
        schema.push_back({"rhexis.tip_radius_mm", "mm",
                          "Distance from the axis of the tip that went on last. Nothing while the tear has no tip."});
        schema.push_back({"rhexis.tip_angle_deg", "deg",
                          "Angle of that tip about the axis: 0 to the surgeon's right, 90 away, -180 to 180."});
        schema.push_back({"rhexis.tip_heading_deg", "deg",
                          "Direction of that tip outward from the circle about the axis; negative: inward."});
        schema.push_back({"rhexis.largest_radius_mm", "mm",
                          "Greatest distance of the opening's edge from the axis. Nothing while there is none."});
        schema.push_back(
            {"rhexis.smallest_radius_mm", "mm",
             "Least distance of the rim from the axis, as it stands. Nothing until the opening is closed."});
        schema.push_back(
            {"rhexis.diameter_mm", "mm",
             "Of the circle that has the opening's area, as it stands, drawn by the zonules. Nothing until "
             "the opening is closed."});
        schema.push_back({"rhexis.circularity", "1",
                          "4 pi area / perimeter^2 of the rim, 1 for a circle. Nothing until the opening is closed."});
        schema.push_back({"rhexis.centre_offset_mm", "mm",
                          "Distance of the opening's middle from the axis. Nothing until the opening is closed."});
        schema.push_back({"rhexis.flap_mm2", "mm^2",
                          "Area between the tear and the chord between its ends; of the opening once it is closed."});
        schema.push_back({"rhexis.overlap_deg", "deg",
                          "Angle over which the rim lies before the optic of an implant 6 mm wide. Nothing until the "
                          "opening is closed."});
        schema.push_back({"rhexis.punctures", "1", "Times that a needle went through the anterior capsule."});
        schema.push_back(
            {"rhexis.puncture_radius_mm", "mm", "Distance of the first of them from the axis. Nothing before it."});
        schema.push_back({"zonules.strain", "1", "Strain of the most stretched zonule, over how it was at the start."});
        schema.push_back({"zonules.peak_strain", "1", "Its greatest value so far."});
        schema.push_back({"rhexis.loose_mm2", "mm^2", "Area of all that has come off the anterior capsule."});
        schema.push_back({"rhexis.tip_x_mm", "mm",
                          "Where that tip lies now, drawn by whatever pulls: to the surgeon's right of the axis."});
        schema.push_back({"rhexis.tip_y_mm", "mm", "Likewise: away from the surgeon."});
        schema.push_back({"rhexis.rest_diameter_mm", "mm",
                          "Of the circle that has the area of what was torn out, without tension. Nothing until the "
                          "opening is closed."});
    }

    void measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                 std::span<double> values) const override {
        const RhexisShape& shape = *lens.rhexis;
        values[0] = shape.opened ? 1.0 : 0.0;
        values[1] = shape.closed ? 1.0 : 0.0;
        values[2] = shape.run_out ? 1.0 : 0.0;
        values[3] = shape.length;
        values[4] = shape.turned * degrees;
        values[5] = shape.tip_radius;
        values[6] = shape.tip_angle * degrees;
        values[7] = shape.tip_heading * degrees;
        values[8] = shape.largest_radius;
        values[9] = shape.smallest_radius;
        values[10] = shape.mean_diameter;
        values[11] = shape.circularity;
        values[12] = shape.centre.norm();
        values[13] = shape.flap_area;
        values[14] = shape.overlap * degrees;
        const MembraneState& state = input.state.membranes[membrane_];
        values[15] = static_cast<double>(state.punctures.size());
        values[16] = state.punctures.empty() ? RhexisShape::none : state.punctures[0].head<2>().norm();
        values[17] = zonule_strain(input.world.membranes[membrane_], state);
        memory[0] = std::max(memory[0], values[17]);
        values[18] = memory[0];
        values[19] = shape.loose_area;
        const bool ends = !shape.lip.empty();
        const Vec3& tip = state.position[ends ? static_cast<std::size_t>(shape.lip[0]) : 0];
        values[20] = ends ? tip.x() : RhexisShape::none;
        values[21] = ends ? tip.y() : RhexisShape::none;
        values[22] = shape.rest_diameter;
    }

private:
    std::size_t membrane_;
};

}  // namespace

std::unique_ptr<MeasureGroup> rhexis_measures(int membrane) { return std::make_unique<RhexisMeasures>(membrane); }

}  // namespace rhexis
