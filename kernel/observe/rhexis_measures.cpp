// SPDX-License-Identifier: GPL-3.0-or-later
// The opening that is torn in the anterior capsule.
#include <numbers>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

class RhexisMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"rhexis.opened", "bool", "There is an opening in the anterior capsule."});
        schema.push_back({"rhexis.closed", "bool", "The tear met its beginning: the flap has come loose."});
        schema.push_back({"rhexis.run_out", "bool", "A tear has run out to the edge of the capsule, at the zonules."});
        schema.push_back({"rhexis.torn_mm", "mm", "Length of all tears of the anterior capsule."});
        schema.push_back({"rhexis.turned_deg", "deg", "Angle about the axis that the tear has gone round, 0 to 360."});
        schema.push_back({"rhexis.tip_radius_mm", "mm",
                          "Distance from the axis of the tip that went on last. Nothing while the tear has no tip."});
        schema.push_back({"rhexis.tip_heading_deg", "deg",
                          "Direction of that tip outward from the circle about the axis; negative: inward."});
        schema.push_back({"rhexis.largest_radius_mm", "mm",
                          "Greatest distance of the opening's edge from the axis. Nothing while there is none."});
        schema.push_back({"rhexis.smallest_radius_mm", "mm",
                          "Least distance of the rim from the axis. Nothing until the opening is closed."});
        schema.push_back({"rhexis.diameter_mm", "mm",
                          "Of the circle that has the opening's area. Nothing until the opening is closed."});
        schema.push_back({"rhexis.circularity", "1",
                          "4 pi area / perimeter^2 of the rim, 1 for a circle. Nothing until the opening is closed."});
        schema.push_back({"rhexis.centre_offset_mm", "mm",
                          "Distance of the opening's middle from the axis. Nothing until the opening is closed."});
        schema.push_back({"rhexis.flap_mm2", "mm^2",
                          "Area between the tear and the chord between its ends; of the opening once it is closed."});
    }

    void measure(const ObserveInput&, const LensView& lens, std::span<double>,
                 std::span<double> values) const override {
        const RhexisShape& shape = *lens.rhexis;
        values[0] = shape.opened ? 1.0 : 0.0;
        values[1] = shape.closed ? 1.0 : 0.0;
        values[2] = shape.run_out ? 1.0 : 0.0;
        values[3] = shape.length;
        values[4] = shape.turned * degrees;
        values[5] = shape.tip_radius;
        values[6] = shape.tip_heading * degrees;
        values[7] = shape.largest_radius;
        values[8] = shape.smallest_radius;
        values[9] = shape.mean_diameter;
        values[10] = shape.circularity;
        values[11] = shape.centre.norm();
        values[12] = shape.flap_area;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> rhexis_measures() { return std::make_unique<RhexisMeasures>(); }

}  // namespace rhexis
