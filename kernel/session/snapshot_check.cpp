// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/snapshot_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "physics/fluid/chamber_flow.hpp"
#include "session/settings.hpp"
#include "topology/come_apart.hpp"
#include "topology/remove.hpp"

namespace rhexis {
namespace {

Error misfit(const std::string& what) { return {what + " does not fit the scene", "snapshot", ""}; }

bool sizes_fit(const SolidModel& model, const SolidState& state) {
    return state.position.size() == model.coarse.nodes.size() && state.velocity.size() == model.coarse.nodes.size() &&
           state.fraction.size() == model.fine.tets.size() && state.present.size() == model.coarse.tets.size();
}

/// Fine tetrahedra that are there, ascending, and shares of their points.
bool spent_fits(const SolidState& state) {
    int last = -1;
    for (const PartlySpent& spent : state.spent) {
        const bool shares =
            std::all_of(spent.left.begin(), spent.left.end(), [](double left) { return left >= 0.0 && left <= 1.0; });
        if (spent.fine <= last || spent.fine >= static_cast<int>(state.fraction.size()) || !shares) {
            return false;
        }
        last = spent.fine;
    }
    return true;
}

bool load_fits(const NodeLoad& load, const WorldModel& world) {
    if (load.solid < 0 || load.solid >= static_cast<int>(world.solids.size())) {
        return false;
    }
    const int nodes = static_cast<int>(world.solids[load.solid].coarse.nodes.size());
    return std::all_of(load.nodes.begin(), load.nodes.end(), [&](int node) { return node >= 0 && node < nodes; });
}

std::size_t partners(const WorldModel& world, ContactPartner partner) {
    switch (partner) {
        case ContactPartner::tool:
            return world.tools.size();
        case ContactPartner::bag:
            return world.bags.size();
        case ContactPartner::plane:
            return world.planes.size();
        case ContactPartner::dome:
            return world.domes.size();
        case ContactPartner::support:
        case ContactPartner::layer:
            return 1;
        case ContactPartner::tube:
        case ContactPartner::sheet:
        case ContactPartner::jaws:
            return 0;
    }
    return 0;
}

bool memory_fits(const ContactMemory& memory, const WorldModel& world) {
    if (memory.solid < 0 || memory.solid >= static_cast<int>(world.solids.size())) {
        return false;
    }
    const SolidModel& solid = world.solids[memory.solid];
    const std::size_t vertices = solid.coarse.nodes.size() + solid.fine.edges.size();
    const std::size_t points = solid.by_points ? 4 * solid.fine.tets.size() : 0;
    return memory.vertex >= 0 && memory.vertex < static_cast<int>(vertices + points) && memory.partner_index >= 0 &&
           memory.partner_index < static_cast<int>(partners(world, memory.partner));
}

Status settings_fit(const Snapshot& snapshot) {
    for (const SettingInfo& info : setting_table()) {
        if (!snapshot.settings.contains(std::string(info.name))) {
            return misfit("a missing setting");
        }
    }
    for (const auto& [name, value] : snapshot.settings) {
        Status status = check_setting(name, value);
        if (!status) {
            return status;
        }
    }
    return success();
}

Status solids_fit(const Snapshot& snapshot, const WorldModel& world) {
    for (std::size_t i = 0; i < world.solids.size(); ++i) {
        if (!sizes_fit(world.solids[i], snapshot.world.solids[i]) || !spent_fits(snapshot.world.solids[i])) {
            return misfit("the mesh of body " + std::to_string(i));
        }
        Status status = validate(world.solids[i], snapshot.world.solids[i]);
        if (!status) {
            return status;
        }
    }
    return success();
}

bool in_sheet(int node, const MembraneState& state) {
    return node >= 0 && node < static_cast<int>(state.sheet->mesh.nodes.size());
}

bool membrane_fits(const MembraneModel& base, const MembraneState& state, int tools) {
    const std::size_t nodes = state.sheet->mesh.nodes.size();
    MembraneModel model = base;
    model.sheet = state.sheet;
    return nodes >= base.sheet->mesh.nodes.size() && check_membrane(model, UnusedNodes::allowed).ok() &&
           state.position.size() == nodes && state.velocity.size() == nodes &&
           std::all_of(state.tips.begin(), state.tips.end(),
                       [&](const TearTip& tip) { return in_sheet(tip.node, state); }) &&
           std::all_of(state.touches.begin(), state.touches.end(),
                       [&](const SheetTouch& touch) {
                           return touch.triangle < static_cast<int>(state.sheet->mesh.triangles.size()) &&
                                  touch.triangle >= -1 && touch.node >= -1 && touch.index >= 0 &&
                                  (touch.node < 0 || in_sheet(touch.node, state));
                       }) &&
           std::all_of(state.grips.begin(), state.grips.end(),
                       [&](const SheetGrip& grip) {
                           return in_sheet(grip.node, state) && grip.tool >= 0 && grip.tool < tools &&
                                  grip.place.allFinite() && std::isfinite(grip.slack);
                       }) &&
           std::all_of(state.punctures.begin(), state.punctures.end(),
                       [](const Vec3& place) { return place.allFinite(); }) &&
           std::isfinite(state.edge_out) && std::isfinite(state.area_out) && std::isfinite(state.support.lift) &&
           std::isfinite(state.support.push) &&
           std::all_of(state.loads.begin(), state.loads.end(), [&](const SheetLoad& load) {
               return !load.nodes.empty() && std::all_of(load.nodes.begin(), load.nodes.end(),
                                                         [&](int node) { return in_sheet(node, state); });
           });
}

Status membranes_fit(const WorldState& state, const WorldModel& world) {
    if (state.membranes.size() != world.membranes.size()) {
        return misfit("the number of membranes");
    }
    for (std::size_t i = 0; i < world.membranes.size(); ++i) {
        if (!membrane_fits(world.membranes[i], state.membranes[i], static_cast<int>(world.tools.size()))) {
            return misfit(world.membranes[i].name);
        }
    }
    return success();
}

Status shells_fit(const WorldState& state, const WorldModel& world) {
    if (state.shells.size() != world.shells.size()) {
        return misfit("the number of shells");
    }
    for (std::size_t i = 0; i < world.shells.size(); ++i) {
        if (Status status = check_shell_state(world.shells[i], state.shells[i]); !status) {
            return status;
        }
    }
    return success();
}

Status plungers_fit(const WorldState& state, const WorldModel& world) {
    const bool fits =
        state.plungers.size() == world.tools.size() &&
        std::all_of(state.plungers.begin(), state.plungers.end(), [](const PlungerState& plunger) {
            return std::isfinite(plunger.pushed) && std::isfinite(plunger.force) && std::isfinite(plunger.stiffness);
        });
    return fits ? success() : Status(misfit("the plungers"));
}

Status microscope_fits(const WorldState& state, const WorldModel& world) {
    const bool fits = state.microscope.has_value() == world.microscope.has_value() &&
                      (!state.microscope || state.microscope->position.allFinite());
    return fits ? success() : Status(misfit("the microscope"));
}

Status globe_fits(const WorldState& state, const WorldModel& world) {
    bool fits = state.globe.has_value() == world.globe.has_value();
    if (fits && state.globe) {
        fits = state.globe->roll.allFinite() && state.globe->roll.norm() <= 1.0;
        for (const Lip& lip : state.globe->lips) {
            fits = fits && lip.deflection.allFinite() && std::isfinite(lip.excursion) && lip.enlargement >= 0.0 &&
                   std::isfinite(lip.enlargement);
        }
    }
    return fits ? success() : Status(misfit("the globe"));
}

Status prolapse_fits(const WorldState& state, const WorldModel& world) {
    bool fits = state.prolapse.has_value() == world.prolapse.has_value();
    if (fits && state.prolapse) {
        const ProlapseState& own = *state.prolapse;
        fits = own.length >= 0.0 && own.damage >= 0.0 && own.damage <= 1.0 &&
               std::isfinite(own.length + own.most + own.pushed + own.stroke_s + own.pull);
    }
    return fits ? success() : Status(misfit("the prolapse of the iris"));
}

bool tool_fits(int tool, const WorldModel& world) { return tool >= -1 && tool < static_cast<int>(world.tools.size()); }

/// Lids, and beads for practice.
Status practice_fits(const WorldState& state, const WorldModel& world) {
    if (state.lids.has_value() != world.lids.has_value() || state.beads.has_value() != world.beads.has_value()) {
        return misfit("lids or beads");
    }
    if (state.lids) {
        const LidsState& lids = *state.lids;
        const double sum = lids.opening + lids.drip + lids.tested[0] + lids.tested[1] + lids.tested[2];
        if (lids.covered.size() != rest_state(*world.lids).covered.size() || !std::isfinite(sum)) {
            return misfit("the lids");
        }
    }
    for (std::size_t i = 0; state.beads && i < state.beads->beads.size(); ++i) {
        const Bead& bead = state.beads->beads[i];
        if (!tool_fits(bead.tool, world) || !bead.position.allFinite() || !bead.off.allFinite()) {
            return misfit("the beads");
        }
    }
    const bool same = !state.beads || state.beads->beads.size() == world.beads->start.size();
    return same ? success() : Status(misfit("the beads"));
}

bool sound(const VitreousState& vitreous) {
    const double sum = vitreous.behind + vitreous.drive + vitreous.wound + vitreous.marked + vitreous.cut +
                       vitreous.traction + vitreous.peak_traction + vitreous.checked + vitreous.filled +
                       vitreous.given + vitreous.open_s + vitreous.inside + vitreous.front[0] + vitreous.front[1] +
                       vitreous.plug[0] + vitreous.plug[1];
    return std::isfinite(sum) && vitreous.caught.allFinite();
}

bool sound(const Wound& wound) {
    const double sum = wound.tunnel + wound.width + wound.passed + wound.left + wound.right + wound.peel +
                       wound.most_peel + wound.swelling + wound.distortion + wound.gape + wound.press + wound.leak +
                       wound.fluid;
    return std::isfinite(sum) && wound.outer.allFinite() && wound.inner.allFinite() && wound.mark.allFinite() &&
           wound.heading.allFinite() && wound.planes >= 0 && wound.sutures >= 0;
}

bool sound(const WoundsState& state) {
    const double sum = state.deepest + state.pressed_s + state.tested_leak + state.peak_press + state.aqueous +
                       state.injected + state.source + state.behind;
    return std::isfinite(sum) && state.bite.allFinite() && state.touches >= 0 && state.caught_at < wound_count &&
           std::all_of(state.wounds.begin(), state.wounds.end(), [](const Wound& wound) { return sound(wound); });
}

Status wounds_fit(const WorldState& state, const WorldModel& world) {
    const bool fits = state.wounds.has_value() == world.wounds.has_value() &&
                      (!state.wounds || (tool_fits(state.wounds->catching, world) && sound(*state.wounds)));
    return fits ? success() : Status(misfit("the wounds"));
}

bool zonules_fit(const BagModel& model, const BagState& state) {
    if (!model.breakable || !state.zonules) {
        return !model.breakable && !state.zonules;
    }
    const ZonuleState& zonules = *state.zonules;
    return zonules.broken.size() == model.zonules.size() && zonules.hooks.size() <= model.breakable->most_hooks &&
           zonules.ring >= 0.0 && zonules.ring <= 1.0 &&
           std::all_of(zonules.hooks.begin(), zonules.hooks.end(), [](const CapsuleHook& hook) {
               return hook.on_bag.allFinite() && hook.at_limbus.allFinite() && std::isfinite(hook.length);
           });
}

bool all_finite(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

Status bag_contents_fit(const WorldState& state, const WorldModel& world) {
    if (state.hydrodissection.has_value() != world.hydrodissection.has_value() ||
        state.cortex.has_value() != world.cortex.has_value() ||
        state.retained.has_value() != world.retained.has_value()) {
        return misfit("hydrodissection, cortex or retained_viscoelastic");
    }
    if (state.hydrodissection) {
        const HydrodissectionState& hydro = *state.hydrodissection;
        const std::array<double, 8> values{hydro.trapped,  hydro.injected,      hydro.filled, hydro.lifted,
                                           hydro.pressure, hydro.peak_pressure, hydro.strain, hydro.burst_s};
        if (static_cast<int>(hydro.cleaved.size()) != cell_count(world.hydrodissection->cells) ||
            !all_finite(hydro.cleaved) || !hydro.entry.allFinite() || !all_finite(values)) {
            return misfit("hydrodissection");
        }
    }
    if (state.cortex) {
        const CortexState& cortex = *state.cortex;
        const int cells = cell_count(world.cortex->cells);
        if (static_cast<int>(cortex.volume.size()) != cells || static_cast<int>(cortex.attached.size()) != cells ||
            !tool_fits(cortex.tool, world) || cortex.cell < -1 || cortex.cell >= cells || !all_finite(cortex.volume) ||
            (cortex.tool >= 0) != (cortex.cell >= 0) || !all_finite(cortex.attached) || !cortex.place.allFinite() ||
            !cortex.pull.allFinite() || !std::isfinite(cortex.taken)) {
            return misfit("the cortex");
        }
    }
    if (state.retained) {
        const RetainedViscoelasticState& left = *state.retained;
        const std::array<double, 6> values{left.front, left.behind, left.angle, left.taken, left.rocked, left.under};
        if (!all_finite(values)) {
            return misfit("the retained viscoelastic");
        }
    }
    return success();
}

Status fluid_fits(const WorldState& state, const WorldModel& world) {
    if (state.chamber.has_value() != world.chamber.has_value() ||
        state.capsule.has_value() != world.capsule.has_value() || state.iris.has_value() != world.iris.has_value() ||
        state.viscoelastic.has_value() != world.viscoelastic.has_value() || state.tips.size() != world.tools.size()) {
        return misfit("chamber, capsule, iris or viscoelastic");
    }
    if (state.vitreous.has_value() != world.vitreous.has_value() ||
        (state.vitreous && !(tool_fits(state.vitreous->tool, world) && sound(*state.vitreous)))) {
        return misfit("the vitreous");
    }
    for (std::size_t i = 0; i < state.bags.size(); ++i) {
        const std::size_t nodes = world.solids.empty() ? 0 : world.solids[0].coarse.nodes.size();
        if (state.bags[i].adherent.size() != (world.bags[i].adherent.empty() ? 0 : nodes)) {
            return misfit("the adhesion of the cortex");
        }
        if (!zonules_fit(world.bags[i], state.bags[i])) {
            return misfit("the zonules");
        }
    }
    if ((state.capsule && !tool_fits(state.capsule->tool, world)) ||
        (state.iris && !tool_fits(state.iris->tool, world))) {
        return misfit("what holds capsule or iris");
    }
    return world.chamber ? check(*world.chamber, *state.chamber) : success();
}

}  // namespace

Status check_splits(const Snapshot& snapshot, const WorldModel& base) {
    if (snapshot.world.solids.size() != base.solids.size()) {
        return misfit("the number of bodies");
    }
    for (std::size_t i = 0; i < base.solids.size(); ++i) {
        if (!splits_fit(base.solids[i], snapshot.world.solids[i].splits)) {
            return misfit("what came apart of body " + std::to_string(i));
        }
    }
    return success();
}

Status check_fit(const Snapshot& snapshot, const WorldModel& world, std::size_t observer_memory) {
    Status solids = solids_fit(snapshot, world);
    if (!solids) {
        return solids;
    }
    const std::vector<NodeLoad>& loads = snapshot.world.loads;
    if (!std::all_of(loads.begin(), loads.end(), [&](const NodeLoad& load) { return load_fits(load, world); })) {
        return misfit("a load");
    }
    const std::vector<ContactMemory>& memory = snapshot.world.memory;
    if (!std::all_of(memory.begin(), memory.end(), [&](const ContactMemory& m) { return memory_fits(m, world); })) {
        return misfit("the memory of a contact");
    }
    if (snapshot.world.bags.size() != world.bags.size() || snapshot.tools.size() != world.tools.size() ||
        snapshot.observer_memory.size() != observer_memory) {
        return misfit("the number of bags, instruments or measures");
    }
    if (Status status = membranes_fit(snapshot.world, world); !status) {
        return status;
    }
    if (Status status = shells_fit(snapshot.world, world); !status) {
        return status;
    }
    if (Status status = plungers_fit(snapshot.world, world); !status) {
        return status;
    }
    if (Status status = fluid_fits(snapshot.world, world); !status) {
        return status;
    }
    if (Status status = wounds_fit(snapshot.world, world); !status) {
        return status;
    }
    if (Status status = bag_contents_fit(snapshot.world, world); !status) {
        return status;
    }
    if (Status status = microscope_fits(snapshot.world, world); !status) {
        return status;
    }
    for (const Status& status : {globe_fits(snapshot.world, world), prolapse_fits(snapshot.world, world)}) {
        if (!status) {
            return status;
        }
    }
    if (Status status = practice_fits(snapshot.world, world); !status) {
        return status;
    }
    return settings_fit(snapshot);
}

}  // namespace rhexis
