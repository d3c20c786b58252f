// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/world.hpp"

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

}  // namespace rhexis
