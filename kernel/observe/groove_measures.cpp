// SPDX-License-Identifier: GPL-3.0-or-later
// Depth, length and width of the groove, and how far its floor is from the posterior capsule.
#include <cmath>
#include <limits>
#include <numbers>

#include "observe/distances.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

class GrooveMeasures : public MeasureGroup {
public:
    explicit GrooveMeasures(bool bag) : bag_(bag) {}

    void describe(ObservationSchema& schema) const override {
        schema.push_back({"groove.exists", "bool", "Tissue has been sculpted away."});
        schema.push_back({"groove.depth_mm", "mm", "Greatest depth below the front surface."});
        schema.push_back({"groove.depth_share", "1", "Greatest depth, share of the lens's thickness there."});
        schema.push_back({"groove.mean_depth_mm", "mm", "Depth of the floor, mean along the groove."});
        schema.push_back({"groove.mean_depth_share", "1", "The same, share of the lens's thickness."});
        schema.push_back({"groove.length_mm", "mm", "Extent along its own direction."});
        schema.push_back({"groove.width_mm", "mm", "Mean width across it."});
        schema.push_back(
            {"groove.direction_deg", "deg", "Its direction, from the surgeon's line of sight to the right."});
        if (bag_) {
            schema.push_back({"groove.floor_posterior_mm", "mm", "Deepest floor to the posterior capsule."});
        }
    }

    void measure(const ObserveInput& input, const LensView& lens, std::span<double>,
                 std::span<double> values) const override {
        const GrooveShape& groove = *lens.groove;
        const double none = std::numeric_limits<double>::quiet_NaN();
        values[0] = groove.exists ? 1.0 : 0.0;
        values[1] = groove.depth;
        values[2] = groove.depth_share;
        values[3] = groove.mean_depth;
        values[4] = groove.mean_depth_share;
        values[5] = groove.length;
        values[6] = groove.width;
        values[7] =
            groove.exists ? std::atan2(groove.direction.x(), groove.direction.y()) * 180.0 / std::numbers::pi : none;
        if (bag_) {
            const Vec3 floor = input.state.bags[0].pose.to_body(lens.motion->to_eye(groove.floor));
            values[8] = groove.exists ? posterior_distance(input.world.bags[0].shape, floor) : none;
        }
    }

private:
    bool bag_;
};

}  // namespace

std::unique_ptr<MeasureGroup> groove_measures(bool bag) { return std::make_unique<GrooveMeasures>(bag); }

}  // namespace rhexis
