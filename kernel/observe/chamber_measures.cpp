// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure and depth of the chamber, and what the machine's panel shows.
#include <algorithm>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr std::size_t parts = 10;    ///< of the second that is looked back on
constexpr double part_s = 0.1;       ///< [s]
constexpr double surge_share = 0.3;  ///< of the depth, lost within a second: a surge

/// Memory. deepest: of each part of the last second, the newest first [mm].
enum Memory : std::size_t {
    started,
    clock_s,
    lowest_pressure,
    least_share,
    surges,
    in_surge,
    deepest,
    memory_count = deepest + parts
};

/// Share of the depth lost since it was deepest within the last second.
double look_back(double dt, double depth, std::span<double> memory) {
    const std::span<double> past = memory.subspan(deepest, parts);
    if (memory[started] == 0.0) {
        std::fill(past.begin(), past.end(), depth);
    }
    memory[clock_s] += dt;
    if (memory[clock_s] >= part_s) {
        memory[clock_s] -= part_s;
        std::shift_right(past.begin(), past.end(), 1);
        past[0] = depth;
    }
    past[0] = std::max(past[0], depth);
    const double most = *std::max_element(past.begin(), past.end());
    return most > 0.0 ? (most - depth) / most : 0.0;
}

void remember(double pressure, double share, double lost, std::span<double> memory) {
    const bool first = memory[started] == 0.0;
    memory[started] = 1.0;
    memory[lowest_pressure] = first ? pressure : std::min(memory[lowest_pressure], pressure);
    memory[least_share] = first ? share : std::min(memory[least_share], share);
    if (lost > surge_share && memory[in_surge] == 0.0) {
        memory[surges] += 1.0;
        memory[in_surge] = 1.0;
    } else if (lost < 0.5 * surge_share) {
        memory[in_surge] = 0.0;
    }
}

class ChamberMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"chamber.pressure_mmhg", "mmHg", "Pressure in the eye."});
        schema.push_back({"chamber.lowest_pressure_mmhg", "mmHg", "The lowest it has been so far."});
        schema.push_back({"chamber.depth_mm", "mm", "Depth of the anterior chamber: front of the cornea to lens."});
        schema.push_back({"chamber.depth_share", "1", "That depth as a share of the depth at the start."});
        schema.push_back({"chamber.least_depth_share", "1", "The least it has been so far."});
        schema.push_back({"chamber.depth_lost_share", "1", "Share of its depth lost within the last second."});
        schema.push_back({"chamber.surges", "1", "Losses of more than 30 % of the depth within a second so far."});
        schema.push_back({"chamber.diaphragm_mm", "mm", "Shift of lens and iris by the fluid; negative: back."});
        schema.push_back({"chamber.infused_ml", "ml", "Fluid from the bottle so far."});
        schema.push_back({"chamber.leaked_ml", "ml", "Fluid lost through the wounds so far."});
        schema.push_back({"chamber.infusion_ml_min", "ml/min", "Flow from the bottle now."});
        schema.push_back({"wound.temperature_c", "degrees C", "Temperature of the main wound around the sleeve."});
        schema.push_back({"wound.burn_share", "1", "Its burn: 0 none, 1 shrunk as far as it goes."});
        schema.push_back({"panel.vacuum_mmhg", "mmHg", "Vacuum in the tubing, as the machine's panel shows it."});
        schema.push_back({"panel.flow_ml_min", "ml/min", "Flow through the pump, as the panel shows it."});
        schema.push_back({"panel.stored_mm3", "mm^3",
                          "What the tubing's vacuum has stored: so much it draws at once when the tip comes free."});
    }
    [[nodiscard]] std::size_t memory_size() const override { return memory_count; }

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        const ChamberModel& model = *input.world.chamber;
        const ChamberState& chamber = *input.state.chamber;
        const ChamberFlows& flows = input.state.flows;
        const double rest = input.eye.anatomy.anterior_chamber_depth;
        const double in_front = volume_in_front(chamber, input.state.wounds ? &*input.state.wounds : nullptr);
        const double depth = std::max(0.0, rest + depth_change(model, in_front));
        const double pressure = eye_pressure(model, chamber.eye_volume) / pascal_per_mmhg;
        const bool stepped = input.state.time_s > 0.0;
        const double lost = look_back(input.dt, depth, memory);
        remember(stepped ? std::min(pressure, flows.lowest_eye_pressure / pascal_per_mmhg) : pressure, depth / rest,
                 lost, memory);
        const double shift =
            input.state.bags.empty() ? diaphragm_shift(model, in_front, 0.0) : input.state.bags[0].cushion_z;
        std::size_t next = 0;
        for (const double value :
             {pressure, memory[lowest_pressure], depth, depth / rest, memory[least_share], lost, memory[surges], shift,
              1e-3 * chamber.totals.infused, 1e-3 * chamber.totals.leaked, flows.infusion / mm3_s_per_ml_min,
              chamber.wound.temperature, burn_share(chamber.wound),
              std::max(0.0, -tube_pressure(model, chamber.tube_volume) / pascal_per_mmhg),
              flows.pump / mm3_s_per_ml_min, std::max(0.0, -chamber.tube_volume)}) {
            values[next++] = value;
        }
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> chamber_measures() { return std::make_unique<ChamberMeasures>(); }

}  // namespace rhexis
