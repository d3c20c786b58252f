// SPDX-License-Identifier: GPL-3.0-or-later
// How close the instruments come to the iris, and how often they touch it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "observe/distances.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

enum Memory : std::size_t { touches, touched, touch_s, memory_count };

class IrisMeasures : public MeasureGroup {
public:
    explicit IrisMeasures(bool moves) : moves_(moves) {}

    void describe(ObservationSchema& schema) const override {
        schema.push_back({"iris.gap_mm", "mm", "Least gap between an instrument and the iris; negative: into it."});
        schema.push_back({"iris.touch", "bool", "An instrument touches the iris."});
        schema.push_back({"iris.touches", "1", "Touches of the iris so far."});
        schema.push_back({"iris.touch_s", "s", "Time in which the iris was touched so far."});
        if (moves_) {
            schema.push_back({"iris.captured", "bool", "A tip that sucks holds the edge of the iris."});
            schema.push_back({"iris.strain", "1", "Strain of the captured iris."});
            schema.push_back({"iris.torn_mm", "mm", "Length of its edge that is torn so far."});
            schema.push_back({"iris.pupil_mm", "mm", "Diameter of the pupil now."});
        }
    }
    [[nodiscard]] std::size_t memory_size() const override { return memory_count; }

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        const double gap = least_gap(input);
        const bool touch = gap <= 0.0;
        // A touch ends only when the gap has opened clearly: a trembling tip is not many touches.
        if (touch && memory[touched] == 0.0) {
            memory[touches] += 1.0;
            memory[touched] = 1.0;
        } else if (!(gap <= 0.05)) {
            memory[touched] = 0.0;
        }
        memory[touch_s] += touch ? input.dt : 0.0;
        values[0] = gap;
        values[1] = touch ? 1.0 : 0.0;
        values[2] = memory[touches];
        values[3] = memory[touch_s];
        if (moves_) {
            const IrisState& iris = *input.state.iris;
            values[4] = iris.tool >= 0 ? 1.0 : 0.0;
            values[5] = iris.strain;
            values[6] = iris.torn;
            values[7] = 2.0 * iris.pupil_radius;
        }
    }

private:
    bool moves_;

    /// NaN when no instrument is in the eye.
    static double least_gap(const ObserveInput& input) {
        double gap = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < input.tools.size(); ++i) {
            const ToolKind kind = input.world.tools[i].kind;
            const bool outside = kind == ToolKind::sponge || kind == ToolKind::needle;  // of the cornea
            if (input.tools[i].present && !outside) {
                gap = std::min(gap, tool_gap(input.world.tools[i], input.tools[i].pose, [&](const Vec3& point) {
                                   return iris_distance(input.eye.anatomy, point);
                               }));
            }
        }
        return std::isinf(gap) ? std::numeric_limits<double>::quiet_NaN() : gap;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> iris_measures(bool moves) { return std::make_unique<IrisMeasures>(moves); }

}  // namespace rhexis
