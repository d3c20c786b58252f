// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/state_hash.hpp"

#include "base/hash.hpp"
#include "session/settings.hpp"

namespace rhexis {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double));

void add(StateHash& hash, const std::vector<Vec3>& vectors) {
    hash.add(static_cast<std::uint64_t>(vectors.size()));
    if (!vectors.empty()) {
        hash.add(std::span<const double>(vectors.front().data(), 3 * vectors.size()));
    }
}

void add(StateHash& hash, const Vec3& vector) { hash.add(std::span<const double>(vector.data(), 3)); }

void add(StateHash& hash, const Pose& pose) {
    add(hash, pose.position);
    hash.add(std::span<const double>(pose.orientation.coeffs().data(), 4));
}

void add(StateHash& hash, const SolidState& solid) {
    add(hash, solid.position);
    add(hash, solid.velocity);
    hash.add(std::span<const double>(solid.fraction));
    for (const PartlySpent& spent : solid.spent) {
        hash.add(static_cast<std::uint64_t>(spent.fine));
        hash.add(std::span<const double>(spent.left));
    }
    hash.add_bytes(solid.present.data(), solid.present.size());
    for (const BrokenFace& face : solid.broken) {
        hash.add((static_cast<std::uint64_t>(face[0]) << 32) | static_cast<std::uint64_t>(face[1]));
    }
    hash.add(static_cast<std::uint64_t>(solid.splits.size()));
    for (const NodeSplit& split : solid.splits) {
        hash.add(static_cast<std::uint64_t>(split.node));
        hash.add_bytes(split.tets.data(), split.tets.size() * sizeof(int));
    }
}

void add(StateHash& hash, const MembraneState& membrane) {
    add(hash, membrane.position);
    add(hash, membrane.velocity);
    add(hash, membrane.sheet->mesh.nodes);
    for (const std::array<int, 3>& triangle : membrane.sheet->mesh.triangles) {
        hash.add_bytes(triangle.data(), sizeof triangle);
    }
    hash.add_bytes(membrane.sheet->origin.data(), membrane.sheet->origin.size() * sizeof(int));
    add(hash, membrane.sheet->fibre);
    hash.add(std::span<const double>(membrane.sheet->thickness));
    hash.add(std::span<const double>(membrane.sheet->stiffness));
    hash.add(static_cast<std::uint64_t>(membrane.tips.size()));
    for (const TearTip& tip : membrane.tips) {
        hash.add(static_cast<std::uint64_t>(tip.node));
        add(hash, tip.direction);
        add(hash, tip.owed);
    }
    hash.add(static_cast<std::uint64_t>(membrane.loads.size()));
    for (const SheetLoad& load : membrane.loads) {
        hash.add_bytes(load.nodes.data(), load.nodes.size() * sizeof(int));
        add(hash, load.total);
    }
    hash.add(static_cast<std::uint64_t>(membrane.touches.size()));
    for (const SheetTouch& touch : membrane.touches) {
        hash.add(static_cast<std::uint64_t>(touch.triangle + 1));
        hash.add(static_cast<std::uint64_t>(touch.node + 1));
        hash.add(static_cast<std::uint64_t>(touch.partner));
        hash.add(static_cast<std::uint64_t>(touch.index));
        add(hash, touch.stretch);
    }
    hash.add(static_cast<std::uint64_t>(membrane.grips.size()));
    for (const SheetGrip& grip : membrane.grips) {
        hash.add(static_cast<std::uint64_t>(grip.tool));
        hash.add(static_cast<std::uint64_t>(grip.node));
        add(hash, grip.place);
        hash.add(static_cast<std::uint64_t>(grip.pushed));
        hash.add(grip.slack);
    }
    hash.add(static_cast<std::uint64_t>(membrane.punctures.size()));
    for (const Vec3& place : membrane.punctures) {
        add(hash, place);
    }
    hash.add(membrane.support.lift);
    hash.add(membrane.support.push);
    hash.add(membrane.torn_area);
    hash.add(membrane.torn_energy);
    if (membrane.edge_out > 0.0) {  // where nothing was taken out the hash is as before there was a word for it
        hash.add(membrane.edge_out);
        hash.add(membrane.area_out);
    }
}

void add(StateHash& hash, const BagState& bag) {
    add(hash, bag.pose);
    add(hash, bag.velocity);
    add(hash, bag.angular_velocity);
    hash.add(bag.cushion_z);
    hash.add(std::span<const double>(bag.load.data(), 6));
    hash.add_bytes(bag.adherent.data(), bag.adherent.size());
    if (bag.zonules) {
        hash.add_bytes(bag.zonules->broken.data(), bag.zonules->broken.size());
        hash.add(static_cast<std::uint64_t>(bag.zonules->hooks.size()));
        for (const CapsuleHook& hook : bag.zonules->hooks) {
            add(hash, hook.on_bag);
            add(hash, hook.at_limbus);
            hash.add(hook.length);
        }
        hash.add(bag.zonules->ring);
    }
}

void add(StateHash& hash, const ShellState& shell) {
    add(hash, shell.position);
    for (const Quat& rotation : shell.rotation) {
        hash.add(std::span<const double>(rotation.coeffs().data(), 4));
    }
    add(hash, shell.velocity);
    add(hash, shell.spin);
    hash.add(std::span<const double>(shell.branch));
    hash.add(static_cast<std::uint64_t>(shell.loads.size()));
    for (const ShellPull& load : shell.loads) {
        hash.add_bytes(load.nodes.data(), load.nodes.size() * sizeof(int));
        add(hash, load.total);
    }
    hash.add(static_cast<std::uint64_t>(shell.touches.size()));
    for (const ShellTouch& touch : shell.touches) {
        hash.add(static_cast<std::uint64_t>(touch.partner));
        hash.add(static_cast<std::uint64_t>(touch.index));
        hash.add(static_cast<std::uint64_t>(touch.sample));
        hash.add(static_cast<std::uint64_t>(touch.front ? 1 : 0));
        add(hash, touch.stretch);
    }
    hash.add(static_cast<std::uint64_t>(shell.loaded ? 1 : 0));
}

void add(StateHash& hash, const NodeLoad& load) {
    hash.add(static_cast<std::uint64_t>(load.solid));
    for (const int node : load.nodes) {
        hash.add(static_cast<std::uint64_t>(node));
    }
    add(hash, load.total);
}

void add(StateHash& hash, const ContactMemory& memory) {
    hash.add(static_cast<std::uint64_t>(memory.solid));
    hash.add(static_cast<std::uint64_t>(memory.vertex));
    hash.add(static_cast<std::uint64_t>(memory.partner));
    hash.add(static_cast<std::uint64_t>(memory.partner_index));
    add(hash, memory.anchor);
    add(hash, memory.force);
}

void add(StateHash& hash, const ToolState& tool) {
    hash.add(static_cast<std::uint64_t>(tool.present ? 1 : 0) + (tool.irrigation ? 2 : 0));
    add(hash, tool.pose);
    add(hash, tool.previous_pose);
    add(hash, tool.velocity);
    add(hash, tool.angular_velocity);
    for (const double value : {tool.jaw, tool.previous_jaw, tool.pedal, tool.aspiration, tool.power, tool.ultrasound_s,
                               tool.bottle_height, tool.pump_flow, tool.vacuum_limit}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const ChamberState& chamber) {
    for (const double value :
         {chamber.eye_volume, chamber.tube_volume, chamber.totals.infused, chamber.totals.vented,
          chamber.totals.aspirated, chamber.totals.leaked, chamber.wound.temperature, chamber.wound.hot_s}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const ChamberFlows& flows) {
    for (const double value : {flows.infusion, flows.tip, flows.pump, flows.leak, flows.vent, flows.lowest_eye_pressure,
                               flows.highest_eye_pressure}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const ViscoelasticState& chamber) {
    for (const double value : {chamber.fill, chamber.injected, chamber.peak_fill}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const CapsuleState& capsule) {
    hash.add(static_cast<std::uint64_t>(capsule.tool + 1) * 2 + (capsule.captured ? 1 : 0));
    for (const Vec3& vector : {capsule.place, capsule.force, capsule.hole_place}) {
        add(hash, vector);
    }
    for (const double value : {capsule.depth, capsule.strain, capsule.hole_radius, capsule.peak_strain}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const LidsState& lids) {
    for (const std::uint8_t covered : lids.covered) {
        hash.add(static_cast<std::uint64_t>(covered));
    }
    for (const double value : {lids.opening, lids.drip, lids.tested[0], lids.tested[1], lids.tested[2]}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const BeadsState& beads) {
    for (const Bead& bead : beads.beads) {
        hash.add(static_cast<std::uint64_t>(bead.tool + 1));
        add(hash, bead.position);
        add(hash, bead.off);
    }
    hash.add(static_cast<std::uint64_t>(beads.grasps));
    hash.add(static_cast<std::uint64_t>(beads.drops));
}

void add(StateHash& hash, const VitreousState& vitreous) {
    hash.add(static_cast<std::uint64_t>(vitreous.tool + 1) * 2 + (vitreous.broken ? 1 : 0));
    add(hash, vitreous.caught);
    for (const double value : {vitreous.behind, vitreous.drive, vitreous.wound, vitreous.marked, vitreous.cut,
                               vitreous.traction, vitreous.peak_traction, vitreous.checked, vitreous.filled,
                               vitreous.given, vitreous.open_s, vitreous.inside}) {
        hash.add(value);
    }
    for (std::size_t i = 0; i < opening_count; ++i) {
        hash.add(vitreous.front[i]);
        hash.add(vitreous.plug[i]);
    }
}

void add(StateHash& hash, const GlobeState& globe) {
    add(hash, globe.roll);
    for (const Lip& lip : globe.lips) {
        add(hash, lip.deflection);
        hash.add(lip.excursion);
        hash.add(lip.enlargement);
    }
}

void add(StateHash& hash, const ProlapseState& prolapse) {
    for (const double value :
         {prolapse.length, prolapse.most, prolapse.damage, prolapse.pushed, prolapse.stroke_s, prolapse.pull}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const Wound& wound) {
    hash.add(static_cast<std::uint64_t>(wound.planes) * 4 + (wound.begun ? 1 : 0) + (wound.cut ? 2 : 0));
    hash.add(static_cast<std::uint64_t>(wound.sutures));
    for (const Vec3* const place : {&wound.outer, &wound.inner, &wound.mark, &wound.heading}) {
        add(hash, *place);
    }
    for (const double value :
         {wound.tunnel, wound.width, wound.passed, wound.left, wound.right, wound.peel, wound.most_peel, wound.swelling,
          wound.distortion, wound.gape, wound.press, wound.leak, wound.fluid}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const WoundsState& state) {
    for (const Wound& wound : state.wounds) {
        add(hash, wound);
    }
    hash.add(static_cast<std::uint64_t>(state.touches) * 8 + (state.touching ? 1 : 0) + (state.stitching ? 2 : 0) +
             (state.checked ? 4 : 0));
    hash.add(static_cast<std::uint64_t>(state.catching + 1) * wound_count + state.caught_at);
    add(hash, state.bite);
    for (const double value : {state.deepest, state.pressed_s, state.tested_leak, state.peak_press, state.aqueous,
                               state.injected, state.source, state.behind}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const HydrodissectionState& hydro) {
    hash.add(std::span<const double>(hydro.cleaved));
    hash.add(static_cast<std::uint64_t>(hydro.entered ? 1 : 0) + (hydro.under_rim ? 2 : 0));
    add(hash, hydro.entry);
    for (const double value : {hydro.trapped, hydro.injected, hydro.filled, hydro.lifted, hydro.pressure,
                               hydro.peak_pressure, hydro.strain, hydro.burst_s}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const CortexState& cortex) {
    hash.add(std::span<const double>(cortex.volume));
    hash.add(std::span<const double>(cortex.attached));
    hash.add(static_cast<std::uint64_t>(cortex.tool + 1) * 2 + (cortex.held ? 1 : 0));
    hash.add(static_cast<std::uint64_t>(cortex.cell + 1));
    add(hash, cortex.place);
    add(hash, cortex.pull);
    hash.add(cortex.taken);
}

void add(StateHash& hash, const RetainedViscoelasticState& retained) {
    for (const double value :
         {retained.front, retained.behind, retained.angle, retained.taken, retained.rocked, retained.under}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const IrisState& iris) {
    hash.add(static_cast<std::uint64_t>(iris.tool + 1));
    add(hash, iris.place);
    for (const double value : {iris.z, iris.pupil_radius, iris.strain, iris.torn}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const TipState& tip) {
    for (const double value :
         {tip.lens, tip.capsule, tip.iris, tip.debris, tip.open, tip.suction, tip.flow, tip.hold}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const PlungerState& plunger) {
    for (const double value : {plunger.pushed, plunger.force, plunger.stiffness}) {
        hash.add(value);
    }
}

void add(StateHash& hash, const Debris& debris) {
    add(hash, debris.position);
    add(hash, debris.velocity);
    for (const double value : {debris.volume, debris.density, debris.ablation_energy}) {
        hash.add(value);
    }
}

template <typename Item>
void add_if(StateHash& hash, const std::optional<Item>& item) {
    hash.add(static_cast<std::uint64_t>(item ? 1 : 0));
    if (item) {
        add(hash, *item);
    }
}

template <typename Items>
void add_all(StateHash& hash, const Items& items) {
    hash.add(static_cast<std::uint64_t>(items.size()));
    for (const auto& item : items) {
        add(hash, item);
    }
}

}  // namespace

std::uint64_t hash_state(const WorldState& world, std::span<const ToolState> tools,
                         const std::map<std::string, double>& settings, std::span<const double> observer_memory,
                         std::uint64_t step, std::uint64_t seed) {
    StateHash hash;
    hash.add(seed);
    hash.add(step);
    add_all(hash, world.solids);
    if (!world.membranes.empty()) {
        add_all(hash, world.membranes);
    }
    if (!world.shells.empty()) {
        add_all(hash, world.shells);
        add_all(hash, world.plungers);
    }
    add_all(hash, world.bags);
    add_if(hash, world.chamber);
    add_if(hash, world.capsule);
    add_if(hash, world.viscoelastic);
    if (world.vitreous) {
        add(hash, *world.vitreous);
    }
    if (world.globe) {
        add(hash, *world.globe);
    }
    if (world.prolapse) {
        add(hash, *world.prolapse);
    }
    if (world.wounds) {
        add(hash, *world.wounds);
    }
    if (world.hydrodissection) {
        add(hash, *world.hydrodissection);
    }
    if (world.cortex) {
        add(hash, *world.cortex);
    }
    if (world.retained) {
        add(hash, *world.retained);
    }
    if (world.microscope) {
        add(hash, world.microscope->position);
    }
    if (world.lids) {
        add(hash, *world.lids);
    }
    if (world.beads) {
        add(hash, *world.beads);
    }
    add_if(hash, world.iris);
    add(hash, world.flows);
    add_all(hash, world.tips);
    add_all(hash, world.debris);
    add_all(hash, world.loads);
    add_all(hash, world.memory);
    add_all(hash, tools);
    for (const double value : {world.removed_mass, world.ablation_energy, world.time_s}) {
        hash.add(value);
    }
    for (const auto& [name, value] : settings) {
        // Only what was set: a setting added to the kernel later must not change the hash of a run that leaves it
        // alone.
        if (const SettingInfo* info = find_setting(name); info == nullptr || info->standard != value) {
            hash.add(std::string_view(name));
            hash.add(value);
        }
    }
    hash.add(observer_memory);
    return hash.value();
}

}  // namespace rhexis
