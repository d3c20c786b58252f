// SPDX-License-Identifier: GPL-3.0-or-later
// Grooves told apart: how many, each one's length, depth and direction, and the angle between the two best.
#include <cmath>
#include <limits>
#include <string>

#include "observe/groove_arms.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr std::size_t described = 2;
constexpr std::size_t per_groove = 6;

void describe_one(const std::string& group, ObservationSchema& schema) {
    schema.push_back({group + "length_mm", "mm", "Extent of this groove along its own direction; 0: not there."});
    schema.push_back({group + "width_mm", "mm", "Mean width across it."});
    schema.push_back({group + "depth_mm", "mm", "Its greatest depth, outside other grooves that cross it."});
    schema.push_back({group + "depth_share", "1", "The same, share of the lens's thickness there."});
    schema.push_back({group + "mean_depth_share", "1", "Depth of its floor, mean along it, share of the thickness."});
    schema.push_back(
        {group + "direction_deg", "deg", "Its direction in the lens as it lay at the start, from +y to the right."});
}

void write_one(const GrooveShape& groove, std::span<double> values) {
    values[0] = groove.length;
    values[1] = groove.width;
    values[2] = groove.depth;
    values[3] = groove.depth_share;
    values[4] = groove.mean_depth_share;
    values[5] = groove.exists ? std::atan2(groove.direction.x(), groove.direction.y()) * degrees
                              : std::numeric_limits<double>::quiet_NaN();
}

class GroovesMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"grooves.count", "1", "Straight grooves that can be told apart."});
        schema.push_back({"grooves.angle_deg", "deg", "Angle between the two best, 0 to 90."});
        for (std::size_t i = 0; i < described; ++i) {
            describe_one("groove_" + std::to_string(i + 1) + ".", schema);
        }
    }

    void measure(const ObserveInput&, const LensView& lens, std::span<double>,
                 std::span<double> values) const override {
        const std::vector<GrooveShape>& arms = *lens.arms;
        values[0] = static_cast<double>(arms.size());
        values[1] =
            arms.size() < 2 ? std::numeric_limits<double>::quiet_NaN() : angle_between(arms[0], arms[1]) * degrees;
        for (std::size_t i = 0; i < described; ++i) {
            write_one(i < arms.size() ? arms[i] : GrooveShape{}, values.subspan(2 + i * per_groove, per_groove));
        }
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> grooves_measures() { return std::make_unique<GroovesMeasures>(); }

}  // namespace rhexis
