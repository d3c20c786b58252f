// SPDX-License-Identifier: GPL-3.0-or-later
// What still bridges the groove.
#include <algorithm>
#include <cmath>
#include <limits>

#include "observe/bridge.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

/// The bridge is looked for anew when faces have broken, pieces have parted, or this much more is gone [mm^3].
constexpr double change = 1.0;

class CrackMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"crack.faces", "1", "Faces between tetrahedra that have given way or that the laser cut."});
        schema.push_back({"crack.bridge_share", "1",
                          "Nucleus that still holds the halves beside groove 1 together: least area that would have to "
                          "part, over that of the whole nucleus there. Nothing while there is no groove."});
        for (const char* axis : {"x", "y", "z"}) {
            schema.push_back({std::string("crack.bridge_").append(axis) + "_mm", "mm",
                              "Where its middle is. Nothing while there is no bridge."});
        }
    }

    [[nodiscard]] std::size_t memory_size() const override { return 5; }

    void measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                 std::span<double> values) const override {
        const SolidState& state = input.state.solids[0];
        const auto broken = static_cast<double>(state.broken.size());
        std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
        values[0] = broken;
        if (lens.arms->empty()) {
            return;
        }
        const double now = 1.0 + broken + 1e-4 * std::floor(lens.fill->removed_volume / change);
        if (now != memory[0]) {
            const GrooveShape& groove = lens.arms->front();
            const double whole = section_area(*lens.model, *lens.grid, groove);
            const Bridge bridge = find_bridge(*lens.model, state, groove);
            memory[0] = now;
            memory[1] = whole > 0.0 ? bridge.area / whole : 0.0;
            std::copy(bridge.place.begin(), bridge.place.end(), memory.begin() + 2);
        }
        values[1] = memory[1];
        if (values[1] > 0.0) {
            const Vec3 place = lens.motion->to_eye(Vec3(memory[2], memory[3], memory[4]));
            std::copy(place.begin(), place.end(), values.begin() + 2);
        }
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> crack_measures() { return std::make_unique<CrackMeasures>(); }

}  // namespace rhexis
