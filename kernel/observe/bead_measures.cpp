// SPDX-License-Identifier: GPL-3.0-or-later
// Beads, and the jaws that take them.
#include <algorithm>
#include <limits>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

class BeadMeasures : public MeasureGroup {
public:
    explicit BeadMeasures(int forceps) : forceps_(forceps) {}

    void describe(ObservationSchema& schema) const override {
        schema.push_back({"beads.count", "1", "How many there are."});
        schema.push_back({"beads.placed", "1", "How many lie in the tray."});
        schema.push_back({"beads.held", "bool", "Jaws hold one."});
        schema.push_back({"beads.grasps", "1", "Times that jaws took one."});
        schema.push_back({"beads.drops", "1", "Times that one was let go or lost beside the tray."});
        schema.push_back(
            {"beads.nearest_mm", "mm", "From the tip of the forceps to the nearest one that is not placed."});
        schema.push_back(
            {"beads.jaw", "1", "Opening of the jaws, 0 closed to 1 open; 0 while they are not in the eye."});
        schema.push_back({"beads.dropped", "bool", "One was let go or lost beside the tray in this step."});
        schema.push_back({"beads.wound_mm", "mm", "From the tip of the forceps to the main wound."});
    }
    [[nodiscard]] std::size_t memory_size() const override { return 1; }

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        const BeadsModel& model = *input.world.beads;
        const BeadsState& state = *input.state.beads;
        const double nothing = std::numeric_limits<double>::quiet_NaN();
        values[0] = static_cast<double>(state.beads.size());
        values[1] = placed_beads(model, state);
        values[2] = std::any_of(state.beads.begin(), state.beads.end(), [](const Bead& b) { return b.tool >= 0; });
        values[3] = state.grasps;
        values[4] = state.drops;
        values[5] = values[8] = nothing;
        values[6] = 0.0;
        values[7] = state.drops > memory[0] ? 1.0 : 0.0;
        memory[0] = state.drops;
        if (forceps_ < 0 || !input.tools[static_cast<std::size_t>(forceps_)].present) {
            return;
        }
        const ToolState& forceps = input.tools[static_cast<std::size_t>(forceps_)];
        for (const Bead& bead : state.beads) {
            const double away = (bead.position - forceps.pose.position).norm();
            if (!over_tray(model, bead.position) && !(values[5] <= away)) {
                values[5] = away;
            }
        }
        values[6] = forceps.jaw;
        values[8] = (input.eye.anatomy.incision - forceps.pose.position).norm();
    }

private:
    int forceps_;
};

}  // namespace

std::unique_ptr<MeasureGroup> bead_measures(int forceps) { return std::make_unique<BeadMeasures>(forceps); }

}  // namespace rhexis
