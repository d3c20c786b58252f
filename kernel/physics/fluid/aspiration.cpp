// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/fluid/aspiration.hpp"

#include <algorithm>

namespace rhexis {

namespace {

constexpr double entry_pressure = 10.0;  ///< at which tissue enters the bore, in Young's moduli. Proposal
constexpr double entry_rate = 3.0;       ///< at twice that [mm^3/s]. Proposal
constexpr double cut_share = 0.7;        ///< of that pressure which full ultrasound power saves. Proposal

/// What is left to take, by either means.
struct Means {
    double seconds = 0.0;  ///< of suction
    double suction = 0.0;  ///< [Pa]
    double pull = 0.0;     ///< share of the mouth that is shut
    double energy = 0.0;   ///< [mJ]
    double power = 0.0;    ///< of ultrasound, share of full
};

/// Volume of a fine tetrahedron of this material that goes. What is emulsified in part is softer in proportion.
double taken(const Material& material, double fraction, double whole, Means& means, double& spent) {
    const double left = fraction * whole;
    const double entry = entry_pressure * (1.0 - cut_share * means.power) * fraction * material.young_modulus;
    double volume = 0.0;
    const double rate = means.pull * entry_rate * (means.suction / entry - 1.0);
    if (rate > 0.0 && means.seconds > 0.0) {
        volume = std::min(left, rate * means.seconds);
        means.seconds -= volume / rate;
    }
    if (material.ablation_energy > 0.0) {
        const double more = std::min(left - volume, means.energy / material.ablation_energy);
        spent = more * material.ablation_energy;
        means.energy -= spent;
        volume += more;
    }
    return volume;
}

}  // namespace

void aspirate(const WorldModel& model, int tool, const ToolState& tool_state, const MouthProbe& probe,
              double spare_energy, double dt, WorldState& state) {
    const TipState& tip = state.tips[tool];
    if (!tool_state.present || probe.points.empty() || !(tip.suction > 0.0) || !(tip.lens > 0.0) ||
        state.solids.empty() || state.solids[0].fraction.empty()) {
        return;
    }
    const SolidModel& lens = model.solids[0];
    SolidState& solid = state.solids[0];
    const double shut = tip.lens * (1.0 - tip.open);
    Means means{dt, tip.suction, shut, shut * spare_energy, tool_state.power};
    for (const BeforeMouth& near : before_mouth(model, state, tool, probe.mouth, tool_state.pose)) {
        const std::array<int, 4>& tet = lens.coarse.tets[near.fine / 8];
        const std::vector<Vec3>& nodes = lens.coarse.nodes;
        const double whole = tet_volume(nodes[tet[0]], nodes[tet[1]], nodes[tet[2]], nodes[tet[3]]) / 8.0;
        const Material& material = lens.materials[lens.coarse.region[near.fine / 8]];
        const double fraction = solid.fraction[near.fine];
        double spent = 0.0;
        if (!(fraction > 0.0)) {
            continue;
        }
        double lost = taken(material, fraction, whole, means, spent) / whole;
        lost = fraction - lost < least_fraction && lost > 0.0 ? fraction : lost;
        set_fraction(solid, near.fine, lost == fraction ? 0.0 : fraction - lost);
        state.removed_mass += lost * whole * material.density;
        state.ablation_energy += spent;
        if (!(means.seconds > 0.0) && !(means.energy > 0.0)) {
            return;
        }
    }
}

}  // namespace rhexis
