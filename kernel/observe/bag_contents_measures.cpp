// SPDX-License-Identifier: GPL-3.0-or-later
// Hydrodissection, cortex and viscoelastic in the bag.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double settling_mm = 0.02;  ///< of a lens that has been moved this little [mm]

bool port_down(const ToolModel& model, const ToolState& tool) {
    return tool.present && (tool.pose.orientation * tip_mouth(model).facing).z() < -0.5;
}

class HydrodissectionMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"hydro.wave_share", "1", "Share of the posterior capsule that the wave has passed."});
        schema.push_back({"hydro.freed_share", "1", "Share of the cortex that no longer adheres to the capsule."});
        schema.push_back({"hydro.under_rim", "bool", "The end of a saline cannula lies under the rim."});
        schema.push_back({"hydro.injected_ml", "ml", "Saline injected so far."});
        schema.push_back({"hydro.bag_pressure_mmhg", "mmHg", "Pressure in the bag beyond that of the chamber."});
        schema.push_back({"hydro.peak_pressure_mmhg", "mmHg", "Its greatest value so far."});
        schema.push_back({"hydro.strain_share", "1",
                          "Strain of the posterior capsule by it, share of what it bears; greatest so far."});
        schema.push_back({"hydro.trapped_mm3", "mm^3", "Fluid trapped behind the nucleus."});
        schema.push_back({"hydro.forward_mm", "mm", "How far the lens stands forward of where the eye alone puts it."});
        schema.push_back({"hydro.block_s", "s", "Time so far with the lens 0.5 mm forward or more."});
        schema.push_back({"hydro.burst", "bool", "The posterior capsule has burst by it."});
        schema.push_back({"hydro.lift_mm3", "mm^3", "Viscoelastic under the lens."});
        schema.push_back({"hydro.viscoelastic_fill", "1", "Share of the chamber that viscoelastic fills."});
        schema.push_back({"hydro.turned_deg", "deg", "How far the lens has been turned either way, at most so far."});
        schema.push_back({"hydro.turned_after_burst_deg", "deg", "How far since the capsule burst."});
    }
    /// strain, block_s, turned, angle at the burst, and what is needed to add whole turns up.
    [[nodiscard]] std::size_t memory_size() const override { return 5; }

    void measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                 std::span<double> values) const override {
        const HydrodissectionModel& model = *input.world.hydrodissection;
        const HydrodissectionState& hydro = *input.state.hydrodissection;
        const BagState& bag = input.state.bags[0];
        const double still =
            diaphragm_shift(*input.world.chamber, input.state.chamber->eye_volume - hydro.trapped, hole_area(input));
        const double forward = bag.pose.position.z() - still;
        memory[0] = std::max(memory[0], hydro.strain / input.world.capsule->ultimate_strain);
        memory[1] += forward > 0.5 ? input.dt : 0.0;
        follow_turn(lens, hydro.burst_s >= 0.0, memory);
        const auto adherent = std::count(bag.adherent.begin(), bag.adherent.end(), std::uint8_t{1});
        const double nodes = static_cast<double>(std::max<std::size_t>(1, bag.adherent.size()));
        std::size_t next = 0;
        for (const double value :
             {wave_share(hydro), 1.0 - static_cast<double>(adherent) / nodes, hydro.under_rim ? 1.0 : 0.0,
              1e-3 * hydro.injected, hydro.pressure / pascal_per_mmhg, hydro.peak_pressure / pascal_per_mmhg, memory[0],
              hydro.trapped, forward > settling_mm ? forward : 0.0, memory[1], hydro.burst_s >= 0.0 ? 1.0 : 0.0,
              hydro.lifted, viscoelastic_fill(model, hydro), memory[2],
              hydro.burst_s >= 0.0 ? std::abs(memory[4] - memory[3]) : 0.0}) {
            values[next++] = value;
        }
    }

private:
    static double hole_area(const ObserveInput& input) {
        return std::numbers::pi * input.state.capsule->hole_radius * input.state.capsule->hole_radius;
    }
    static void follow_turn(const LensView& lens, bool burst, std::span<double> memory) {
        const double angle = std::atan2(lens.motion->turn.y(), lens.motion->turn.x()) * 180.0 / std::numbers::pi;
        memory[4] = angle + 360.0 * std::round((memory[4] - angle) / 360.0);
        memory[2] = std::max(memory[2], std::abs(memory[4]));
        memory[3] = burst ? memory[3] : memory[4];
    }
};

class CortexMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"cortex.left_percent", "%", "Cortex left, share of the bag's area."});
        schema.push_back({"cortex.loose_percent", "%", "Share of the bag's area over which it lies stripped."});
        schema.push_back({"cortex.held", "bool", "A mouth holds some."});
        schema.push_back({"cortex.pull_mN", "mN", "Pull on what is held."});
        schema.push_back({"cortex.taken_mm3", "mm^3", "Aspirated so far."});
    }

    void measure(const ObserveInput& input, const LensView&, std::span<double>,
                 std::span<double> values) const override {
        const CortexModel& model = *input.world.cortex;
        const CortexState& cortex = *input.state.cortex;
        std::size_t loose = 0;
        for (std::size_t i = 0; i < cortex.volume.size(); ++i) {
            loose += cortex.volume[i] > 0.0 && !(cortex.attached[i] > 0.0) ? 1 : 0;
        }
        values[0] = 100.0 * cortex_left(model, cortex);
        values[1] = 100.0 * static_cast<double>(loose) / static_cast<double>(cell_count(model.cells));
        values[2] = cortex.held ? 1.0 : 0.0;
        values[3] = 1e-3 * cortex.pull.norm();
        values[4] = cortex.taken;
    }
};

class RetainedViscoelasticMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"viscoelastic.left_percent", "%", "Viscoelastic left, share of what there was."});
        schema.push_back({"viscoelastic.front_mm3", "mm^3", "In front of the implant."});
        schema.push_back({"viscoelastic.behind_mm3", "mm^3", "Behind it."});
        schema.push_back({"viscoelastic.behind_percent", "%", "Behind it, share of all that there was."});
        schema.push_back({"viscoelastic.angle_mm3", "mm^3", "In the angle of the chamber."});
        schema.push_back({"viscoelastic.rocked", "1", "How far the tip tilts the implant: 0 to 1."});
        schema.push_back({"viscoelastic.under_optic", "bool", "The mouth of the tip lies behind the implant."});
    }

    void measure(const ObserveInput& input, const LensView&, std::span<double>,
                 std::span<double> values) const override {
        const RetainedViscoelasticState& left = *input.state.retained;
        const double start = viscoelastic_at_start(*input.world.retained);
        std::size_t next = 0;
        for (const double value :
             {start > 0.0 ? 100.0 * viscoelastic_left(left) / start : 0.0, left.front, left.behind,
              start > 0.0 ? 100.0 * left.behind / start : 0.0, left.angle, left.rocked, left.under}) {
            values[next++] = value;
        }
    }
};

/// How an aspirator with its mouth in its side is turned, and how long it sucked at what lies behind.
class PortMeasures : public MeasureGroup {
public:
    explicit PortMeasures(const ToolModel& model, int tool) : model_(model), tool_(static_cast<std::size_t>(tool)) {}
    void describe(ObservationSchema& schema) const override {
        schema.push_back({model_.name + ".port_down", "bool", "Its mouth looks at the back of the eye."});
        schema.push_back(
            {model_.name + ".port_down_s", "s", "Time so far in which it did and sucked with more than 50 mmHg."});
    }
    [[nodiscard]] std::size_t memory_size() const override { return 1; }

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        const bool down = port_down(model_, input.tools[tool_]);
        memory[0] += down && input.state.tips[tool_].suction > 50.0 * pascal_per_mmhg ? input.dt : 0.0;
        values[0] = down ? 1.0 : 0.0;
        values[1] = memory[0];
    }

private:
    ToolModel model_;
    std::size_t tool_;
};

}  // namespace

std::unique_ptr<MeasureGroup> hydrodissection_measures() { return std::make_unique<HydrodissectionMeasures>(); }
std::unique_ptr<MeasureGroup> cortex_measures() { return std::make_unique<CortexMeasures>(); }
std::unique_ptr<MeasureGroup> retained_viscoelastic_measures() {
    return std::make_unique<RetainedViscoelasticMeasures>();
}
std::unique_ptr<MeasureGroup> port_measures(const ToolModel& model, int tool) {
    return std::make_unique<PortMeasures>(model, tool);
}

}  // namespace rhexis
