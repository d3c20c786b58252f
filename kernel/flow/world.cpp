// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/world.hpp"

#include <algorithm>

namespace rhexis {

WorldState rest_state(const WorldModel& model) {
    WorldState state;
    for (const SolidModel& solid : model.solids) {
        state.solids.push_back(rest_state(solid));
    }
    for (const MembraneModel& membrane : model.membranes) {
        state.membranes.push_back(rest_state(membrane));
    }
    for (const ShellModel& shell : model.shells) {
        state.shells.push_back(rest_state(shell));
    }
    state.bags.resize(model.bags.size());
    for (std::size_t i = 0; i < model.bags.size(); ++i) {
        state.bags[i].adherent = model.bags[i].adherent;
        if (model.bags[i].breakable) {
            state.bags[i].zonules = rest_state(*model.bags[i].breakable);
        }
    }
    state.tips.resize(model.tools.size());
    state.plungers.resize(model.tools.size());
    if (model.chamber) {
        state.chamber = chamber_state(*model.chamber, model.chamber->rest_pressure, 0.0);
    }
    if (model.capsule) {
        state.capsule = CapsuleState{};
        state.capsule->hole_radius = model.capsule->start_hole;
        state.capsule->hole_place = model.capsule->start_hole_place;
    }
    if (model.iris) {
        state.iris = rest_state(*model.iris);
    }
    if (model.viscoelastic) {
        const double fill = model.viscoelastic->start_fill;
        state.viscoelastic = ViscoelasticState{fill, 0.0, fill};
    }
    if (model.vitreous) {
        state.vitreous = rest_state(*model.vitreous, *model.chamber);
    }
    if (model.wounds) {
        state.wounds = rest_state(*model.wounds);
        state.chamber->wound = burnt_wound(model.wounds->start_burn);
    }
    if (model.globe) {
        state.globe = GlobeState{};
    }
    if (model.prolapse) {
        state.prolapse = ProlapseState{};
    }
    if (model.hydrodissection) {
        state.hydrodissection = rest_state(*model.hydrodissection);
        const double excess = std::max(0.0, model.hydrodissection->start_fill - 1.0);
        state.chamber->eye_volume += excess * model.hydrodissection->chamber_volume;
    }
    if (model.cortex) {
        state.cortex = rest_state(*model.cortex);
    }
    if (model.retained) {
        state.retained = rest_state(*model.retained);
    }
    if (model.microscope) {
        state.microscope = MicroscopeState{model.microscope->start};
    }
    if (model.lids) {
        state.lids = rest_state(*model.lids);
    }
    if (model.beads) {
        state.beads = rest_state(*model.beads);
    }
    return state;
}

Vec3 vitreous_place(const WorldModel& model, const std::vector<BagState>& bags, const CapsuleState& capsule,
                    const VitreousState& vitreous) {
    const BagState& bag = bags[0];
    if (bag.zonules && vitreous.front[zonule_gap] > vitreous.front[capsule_hole]) {
        return bag.pose.to_world(model.bags[0].shape.radius * widest_gap(model.bags[0], *bag.zonules).middle);
    }
    return bag.pose.to_world(capsule.hole_place);
}

}  // namespace rhexis
