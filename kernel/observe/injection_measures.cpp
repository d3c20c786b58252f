// SPDX-License-Identifier: GPL-3.0-or-later
// How far an injector has pushed its implant out, and how hard. How that lies: implant_measures.cpp.
#include <algorithm>

#include "base/index.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double jam = 0.9;  // of the most force

/// Share of the implant's nodes that are before the tip of the injector.
double delivered(const ShellState& implant, const ToolState& injector) {
    if (implant.loaded || !injector.present) {
        return implant.loaded ? 0.0 : 1.0;
    }
    const auto out = std::count_if(implant.position.begin(), implant.position.end(),
                                   [&](const Vec3& place) { return injector.pose.to_body(place).z() < 0.0; });
    return static_cast<double>(out) / static_cast<double>(implant.position.size());
}

class InjectionMeasures : public MeasureGroup {
public:
    explicit InjectionMeasures(int injector) : injector_(injector) {}

    void describe(ObservationSchema& schema) const override {
        schema.push_back({"implant.delivered", "1", "Share of the implant that is out of the injector."});
        schema.push_back({"injector.plunger_mm", "mm", "How far the plunger is, which gives way when it jams."});
        schema.push_back({"injector.force_mN", "mN", "Force of the plunger on the implant, along the bore."});
        schema.push_back({"injector.jammed", "bool", "The plunger has needed nine tenths of all the force of a hand."});
    }

    [[nodiscard]] std::size_t memory_size() const override { return 1; }  // whether it has jammed

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        const ToolState& tool = input.tools[at(injector_)];
        const PlungerState& plunger = input.state.plungers[at(injector_)];
        const double most = input.world.tools[at(injector_)].cartridge->most_force;
        memory[0] = memory[0] > 0.0 || plunger.force > jam * most ? 1.0 : 0.0;
        values[0] = delivered(input.state.shells[0], tool);
        values[1] = tool.present ? plunger.pushed : 0.0;
        values[2] = 1e-3 * plunger.force;
        values[3] = memory[0];
    }

private:
    int injector_;
};

}  // namespace

std::unique_ptr<MeasureGroup> injection_measures(int injector) { return std::make_unique<InjectionMeasures>(injector); }

}  // namespace rhexis
