// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/aspiration.hpp"

#include <algorithm>

#include "physics/tissue_near.hpp"

namespace rhexis {

namespace {

constexpr double entry_pressure = 10.0;   ///< at which tissue enters the bore, in Young's moduli. Proposal
constexpr double entry_rate = 3.0;       ///< at twice that [mm^3/s]. Proposal
constexpr double least_fraction = 0.01;  ///< less than this drifts away and counts as removed

/// A fine tetrahedron before the mouth.
struct Before {
    int fine = 0;
    double distance = 0.0;  ///< of its middle from the mouth's [mm]
};

/// Nearest first.
std::vector<Before> before_mouth(const WorldModel& model, const WorldState& state, const ToolModel& tool,
                                 const Mouth& mouth, const Pose& pose) {
    std::vector<Before> found;
    const double wide = tool.bore_radius + seal;
    for (const FineTissue& fine : tissue_near(model.solids[0], state.solids[0], tool.parts.front(), pose, kept_seal)) {
        const Vec3 middle = 0.25 * (fine.corners[0] + fine.corners[1] + fine.corners[2] + fine.corners[3]);
        const Vec3 from_mouth = pose.to_body(middle) - mouth.centre;
        const double along = mouth.facing.dot(from_mouth);
        if (along > -seal && from_mouth.squaredNorm() - along * along < wide * wide) {
            found.push_back({fine.tet, from_mouth.norm()});
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Before& a, const Before& b) { return a.distance < b.distance; });
    return found;
}

/// What is left to take, by either means.
struct Means {
    double seconds = 0.0;   ///< of suction
    double suction = 0.0;   ///< [Pa]
    double pull = 0.0;      ///< share of the mouth that is shut
    double energy = 0.0;    ///< [mJ]
};

/// Volume of this material that goes, at most `left` [mm^3].
double taken(const Material& material, double left, Means& means, double& spent) {
    double volume = 0.0;
    const double rate = means.pull * entry_rate * (means.suction / (entry_pressure * material.young_modulus) - 1.0);
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
    Means means{dt, tip.suction, shut, shut * spare_energy};
    for (const Before& near : before_mouth(model, state, model.tools[tool], probe.mouth, tool_state.pose)) {
        const std::array<int, 4>& tet = lens.coarse.tets[near.fine / 8];
        const std::vector<Vec3>& nodes = lens.coarse.nodes;
        const double whole = tet_volume(nodes[tet[0]], nodes[tet[1]], nodes[tet[2]], nodes[tet[3]]) / 8.0;
        const Material& material = lens.materials[lens.coarse.region[near.fine / 8]];
        double& fraction = solid.fraction[near.fine];
        double spent = 0.0;
        double lost = taken(material, fraction * whole, means, spent) / whole;
        lost = fraction - lost < least_fraction && lost > 0.0 ? fraction : lost;
        fraction = lost == fraction ? 0.0 : fraction - lost;
        state.removed_mass += lost * whole * material.density;
        state.ablation_energy += spent;
        if (!(means.seconds > 0.0) && !(means.energy > 0.0)) {
            return;
        }
    }
}

}  // namespace rhexis
