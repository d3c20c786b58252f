// SPDX-License-Identifier: GPL-3.0-or-later
// What still bridges the groove.
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
    }

    [[nodiscard]] std::size_t memory_size() const override { return 2; }

    void measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                 std::span<double> values) const override {
        const SolidState& state = input.state.solids[0];
        const auto broken = static_cast<double>(state.broken.size());
        values[0] = broken;
        values[1] = std::numeric_limits<double>::quiet_NaN();
        if (lens.arms->empty()) {
            return;
        }
        double& looked_at = memory[0];
        double& share = memory[1];
        const double now = 1.0 + broken + 1e-4 * std::floor(lens.fill->removed_volume / change);
        if (now != looked_at) {
            const GrooveShape& groove = lens.arms->front();
            const double whole = section_area(*lens.model, *lens.grid, groove);
            looked_at = now;
            share = whole > 0.0 ? bridge_area(*lens.model, state, groove) / whole : 0.0;
        }
        values[1] = share;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> crack_measures() { return std::make_unique<CrackMeasures>(); }

}  // namespace rhexis
