// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/fluid/hydrodissection_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/anatomy/bag_motion.hpp"

namespace rhexis {

namespace {

constexpr double in_rim = 0.15;        ///< inside the opening's edge, fluid still comes under it [mm]. Proposal
constexpr double above_capsule = 0.3;  ///< outside of it: the end lifts the capsule a little [mm]. Proposal
constexpr double no_way = 0.05;        ///< share of the way out that viscoelastic leaves at least. Proposal
constexpr double all_free = 1.15;      ///< fill less than this by 1 leaves the whole way. Proposal
constexpr double taken_along = 0.5;    ///< of viscoelastic, beside its share, by what leaks. Proposal
constexpr double drains_s = 0.1;       ///< trapped fluid, through a burst capsule [s]. Proposal
constexpr double under_lens = 0.3;     ///< viscoelastic so far behind the rim's plane lifts the lens [mm]. Proposal
constexpr double beside_rim =
    0.3;  ///< nearer to the edge than this a cannula does not press the lens back [mm]. Proposal
constexpr double gives_way = 0.5;  ///< of the nucleus, share of the depth to which an end stands in it. Proposal
constexpr int parts = 4;           ///< of a step, in each of which saline, wave and outflow follow one another
constexpr double away = 0.3;       ///< of the bag's radius, across from where saline comes in, it bursts. Proposal

/// What an instrument's syringe gives in a step [mm^3].
double pressed_out(const HydrodissectionModel& own, const ToolState& tool, double pressure, double dt) {
    return own.injection * tool.jaw * std::clamp(1.0 - pressure / own.most_pressure, 0.0, 1.0) * dt;
}

/// Between rim and equator, close to the capsule.
bool lies_under_rim(const HydrodissectionModel& own, const BagShape& bag, const Vec3& local) {
    const double inside = -bag_distance(bag, local).distance;
    return local.head<2>().norm() > own.opening_radius - in_rim && local.z() > -0.5 && inside > -above_capsule &&
           inside < own.under;
}

/// With which instruments press the lens back, spread over it [Pa].
double press_of(const WorldModel& model, const WorldState& state) {
    const BagState& bag = state.bags[0];
    const double lift = suspension_wrench(model.bags[0], bag, bag.pose).z();
    return std::max(0.0, lift) / model.hydrodissection->lens_area;
}

/// How far an instrument that stands in the front of the lens has pressed it back from the opening [mm].
double pressed_in(const HydrodissectionModel& own, const WorldModel& model, std::span<const ToolState> tools,
                  const Pose& bag) {
    double deepest = 0.0;
    for (const ToolState& tool : tools) {
        const Vec3 local = bag.to_body(tool.pose.position);
        if (tool.present && local.z() > 0.0 && local.head<2>().norm() < own.opening_radius - beside_rim) {
            deepest = std::max(deepest, -bag_distance(model.bags[0].shape, local).distance);
        }
    }
    return gives_way * deepest;
}

/// Share of the way past the nucleus that is open: shut as the lens comes forward, or viscoelastic lies before it.
double open_way(const WorldModel& model, std::span<const ToolState> tools, const WorldState& state) {
    const HydrodissectionModel& own = *model.hydrodissection;
    const double still = state.chamber->eye_volume - state.hydrodissection->trapped;
    const Pose& bag = state.bags[0].pose;
    const double forward = bag.position.z() - diaphragm_shift(*model.chamber, still, 0.0);
    const double shut = std::max(0.0, forward - pressed_in(own, model, tools, bag)) / own.seal;
    const double gap = std::clamp(1.0 - shut, own.sealed, 1.0);
    return gap * std::clamp(all_free - viscoelastic_fill(own, *state.hydrodissection), no_way, 1.0);
}

/// Spends `volume` on the cells that pressure reaches, the nearest to the entry first. Returns what was left over.
double spread_wave(const HydrodissectionModel& own, double volume, double pressure, HydrodissectionState& hydro) {
    const double cell = own.layer * std::numbers::pi * own.cells.radius * own.cells.radius / cell_count(own.cells);
    const double reach = own.reach * (1.0 - own.cleaving / pressure);
    while (volume > 0.0) {
        int nearest = -1;
        double best = reach;
        for (int i = 0; i < cell_count(own.cells); ++i) {
            const double way = (cell_middle(own.cells, i) - hydro.entry.head<2>()).norm();
            if (hydro.cleaved[static_cast<std::size_t>(i)] < 1.0 && way < best) {
                best = way;
                nearest = i;
            }
        }
        if (nearest < 0) {
            break;
        }
        double& share = hydro.cleaved[static_cast<std::size_t>(nearest)];
        const double more = std::min(1.0 - share, volume / cell);
        share = share + more > 1.0 - 1e-9 ? 1.0 : share + more;
        volume -= more * cell;
    }
    return std::max(0.0, volume);
}

/// A part of what is trapped goes into the wave.
void advance_wave(const HydrodissectionModel& own, double pressure, double dt, HydrodissectionState& hydro) {
    if (!hydro.entered || !(pressure > own.cleaving)) {
        return;
    }
    const double offered = std::min(hydro.trapped, own.wave_flow * (pressure - own.cleaving) * dt);
    hydro.trapped -= offered - spread_wave(own, offered, pressure, hydro);
}

/// Implicit in what is trapped, so that no step is too long.
void let_out(const HydrodissectionModel& own, double open, double press, double dt, HydrodissectionState& hydro) {
    if (hydro.burst_s >= 0.0) {
        hydro.trapped /= 1.0 + dt / drains_s;
        return;
    }
    const double rate = own.egress * open * dt;
    const double per_volume = own.stiffness * (1.0 + hydro.trapped / own.stiffening);
    hydro.trapped = std::max(0.0, (hydro.trapped - rate * press) / (1.0 + rate * per_volume));
}

void give_saline(const WorldModel& model, const ToolModel& tool, const ToolState& now, double dt, WorldState& state) {
    const HydrodissectionModel& own = *model.hydrodissection;
    HydrodissectionState& hydro = *state.hydrodissection;
    Vec3 local = state.bags[0].pose.to_body(now.pose.position);
    local.z() += forward_shift(own, hydro);  // what is trapped lifts the lens past the cannula, not the rim over it
    const bool under = lies_under_rim(own, model.bags[0].shape, local);
    hydro.under_rim = hydro.under_rim || (tool.saline && under);
    const double outside = eye_pressure(*model.chamber, state.chamber->eye_volume);
    const double volume = pressed_out(own, now, outside + (under ? hydro.pressure : 0.0), dt);
    state.chamber->eye_volume += volume;
    if (!tool.saline) {
        const bool lifts = local.z() < model.bags[0].shape.anterior - under_lens && local.head<2>().norm() > 2.0;
        (lifts ? hydro.lifted : hydro.filled) += volume;
        return;
    }
    hydro.injected += volume;
    if (volume > 0.0 && under) {
        hydro.trapped += volume;
        hydro.entry = local;
        hydro.entered = true;
    }
}

/// Cortex over a cell that the wave has parted.
void free_cortex(const HydrodissectionModel& own, const HydrodissectionState& hydro, BagState& bag) {
    for (std::size_t node = 0; node < own.cell_of_node.size() && node < bag.adherent.size(); ++node) {
        if (hydro.cleaved[static_cast<std::size_t>(own.cell_of_node[node])] >= 1.0) {
            bag.adherent[node] = 0;
        }
    }
}

/// What syringes give, the wave and what comes out, one after the other.
void advance_trapped(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state) {
    const HydrodissectionModel& own = *model.hydrodissection;
    HydrodissectionState& hydro = *state.hydrodissection;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (model.tools[i].kind == ToolKind::cannula && tools[i].present) {
            give_saline(model, model.tools[i], tools[i], dt, state);
        }
    }
    const double press = press_of(model, state);
    const double pressure = trapped_pressure(own, hydro.trapped) + (hydro.trapped > 0.0 ? press : 0.0);
    advance_wave(own, pressure, dt, hydro);
    let_out(own, open_way(model, tools, state), press, dt, hydro);
    hydro.pressure = trapped_pressure(own, hydro.trapped) + (hydro.trapped > 0.0 ? press : 0.0);
    hydro.peak_pressure = std::max(hydro.peak_pressure, hydro.pressure);
}

void burst(const WorldModel& model, WorldState& state) {
    HydrodissectionState& hydro = *state.hydrodissection;
    const BagShape& bag = model.bags[0].shape;
    hydro.burst_s = 0.0;
    const Vec2 across = hydro.entry.head<2>();
    const double far = across.norm();
    const Vec2 place = far > 0.0 ? Vec2(-away * bag.radius / far * across) : Vec2(Vec2::Zero());
    CapsuleState& capsule = *state.capsule;
    if (capsule.hole_radius == 0.0) {
        capsule.hole_place = Vec3(place.x(), place.y(), -bag.posterior * std::sqrt(1.0 - away * away));
    }
    capsule.hole_radius = std::max(capsule.hole_radius, model.hydrodissection->first_tear);
}

}  // namespace

double trapped_pressure(const HydrodissectionModel& model, double trapped) {
    return model.stiffness * trapped * (1.0 + trapped / model.stiffening);
}

double trapped_strain(const WorldModel& model, double pressure) {
    const CapsuleModel& capsule = *model.capsule;
    const BagShape& bag = model.bags[0].shape;
    const double wall_radius = bag.radius * bag.radius / bag.posterior;
    return model.hydrodissection->wall_share * pressure * wall_radius * (1.0 - capsule.poisson_ratio) /
           (2.0 * capsule.membrane_stiffness);
}

void hydrodissect(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state) {
    state.hydrodissection->under_rim = false;
    for (int part = 0; part < parts; ++part) {
        advance_trapped(model, tools, dt / parts, state);
    }
    free_cortex(*model.hydrodissection, *state.hydrodissection, state.bags[0]);
}

double hydrodissection_release(const HydrodissectionModel& model, std::span<const ToolState> tools, double pressure) {
    const bool any = std::any_of(tools.begin(), tools.end(), [](const ToolState& tool) { return tool.present; });
    return any ? model.gape * std::clamp((pressure - model.lip) / (0.5 * model.lip), 0.0, 1.0) : 0.0;
}

void strain_by_trapped(const WorldModel& model, double dt, WorldState& state) {
    HydrodissectionState& hydro = *state.hydrodissection;
    const double fill = std::min(1.0, viscoelastic_fill(*model.hydrodissection, hydro));
    const double gone = taken_along * fill * std::max(0.0, state.flows.leak) * dt;
    hydro.filled = std::max(0.0, hydro.filled - gone);
    hydro.strain = trapped_strain(model, hydro.pressure);
    if (hydro.burst_s >= 0.0) {
        hydro.burst_s += dt;
    } else if (hydro.strain > model.capsule->ultimate_strain) {
        burst(model, state);
    }
}

}  // namespace rhexis
