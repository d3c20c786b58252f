// SPDX-License-Identifier: GPL-3.0-or-later
// How long no instrument has been in the eye: a hand that changes them is soon back.
#include <algorithm>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

class PresenceMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back(
            {"instruments.out_s", "s", "Time since the last instrument left the eye; 0 while one is in it."});
    }
    [[nodiscard]] std::size_t memory_size() const override { return 1; }

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        const bool any =
            std::any_of(input.tools.begin(), input.tools.end(), [](const ToolState& tool) { return tool.present; });
        memory[0] = any ? 0.0 : memory[0] + input.dt;
        values[0] = memory[0];
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> presence_measures() { return std::make_unique<PresenceMeasures>(); }

}  // namespace rhexis
