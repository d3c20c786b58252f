// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/fluid/fluid_step.hpp"

#include <algorithm>
#include <numbers>

#include "mesh/places.hpp"
#include "physics/anatomy/bag_contents.hpp"
#include "physics/anatomy/globe_roll.hpp"
#include "physics/anatomy/iris_motion.hpp"
#include "physics/anatomy/iris_prolapse.hpp"
#include "physics/anatomy/wound_closing.hpp"
#include "physics/anatomy/wound_cutting.hpp"
#include "physics/anatomy/wound_heat.hpp"
#include "physics/fluid/chamber_flow.hpp"
#include "physics/fluid/hydrodissection_flow.hpp"
#include "physics/fluid/vitreous_motion.hpp"

namespace rhexis {

namespace {

constexpr double widest_open = 30.0;  ///< that the chamber is made for

double hole_area(const WorldState& state) {
    return state.capsule ? std::numbers::pi * state.capsule->hole_radius * state.capsule->hole_radius : 0.0;
}

/// Where the vitreous holds the bag: with the diaphragm, and before what is trapped behind the lens [mm].
double lens_shift(const WorldModel& model, const WorldState& state) {
    double volume = volume_in_front(*state.chamber, state.wounds ? &*state.wounds : nullptr);
    double forward = 0.0;
    if (model.hydrodissection) {
        volume -= state.hydrodissection->trapped;
        forward = forward_shift(*model.hydrodissection, *state.hydrodissection);
    }
    return diaphragm_shift(*model.chamber, volume, hole_area(state)) + forward;
}

/// Index of the handpiece that the machine serves; -1: none is in the eye.
int handpiece(std::span<const ToolState> tools, std::span<const MouthProbe> probes) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (tools[i].present && !probes[i].points.empty()) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

}  // namespace

Vec3 inflow(const Vec3& mouth, double flow, double bore, const Vec3& place) {
    const Vec3 way = mouth - place;
    const double square = std::max(way.squaredNorm(), bore * bore);
    return flow / (2.0 * std::numbers::pi * square) * way.normalized();
}

ChamberControl chamber_control(const WorldModel& model, std::span<const ToolState> tools,
                               std::span<const TipState> tips, std::span<const MouthProbe> probes,
                               const WoundState& wound) {
    ChamberControl control;
    control.vent = true;
    control.wound_open =
        wound_gape(wound, std::any_of(tools.begin(), tools.end(), [](const ToolState& tool) { return tool.present; }));
    const int hand = handpiece(tools, probes);
    if (hand < 0 || !model.chamber) {
        control.tip_open = 0.0;
        return control;
    }
    const ToolState& tool = tools[hand];
    control.irrigation = tool.irrigation;
    control.vent = !(tool.aspiration > 0.0);
    control.bottle_height = tool.bottle_height;
    control.pump_flow = tool.pump_flow;
    control.vacuum_limit = tool.vacuum_limit;
    // With the pump at rest its rollers close the tubing.
    control.tip_open = tool.aspiration > 0.0 ? tips[hand].open : 0.0;
    return control;
}

void step_fluid(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                double dt, WorldState& state) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        state.tips[i] = look_at_mouth(model, state, static_cast<int>(i), tools[i], probes[i]);
    }
    if (model.chamber) {
        const ChamberModel& chamber = *model.chamber;
        const int hand = handpiece(tools, probes);
        if (model.vitreous) {
            lay_viscoelastic(model, tools, probes, dt, state);
        }
        if (model.wounds) {
            cut_wounds(model, tools, dt, state);
            close_wounds(model, tools, dt, state);
        }
        if (model.cortex) {
            look_for_cortex(model, tools, probes, state);
        }
        ChamberControl control = chamber_control(model, tools, state.tips, probes, state.chamber->wound);
        if (model.wounds) {
            control.wound_open = wounds_open(model, tools, state);
        }
        if (model.prolapse) {  // it is the main wound that leaks
            control.wound_open *= unplugged_share(*model.prolapse, *state.prolapse);
        }
        if (model.vitreous) {
            control.wound_open = wound_release(*model.vitreous, *state.vitreous, control.wound_open);
        }
        if (model.hydrodissection) {
            hydrodissect(model, tools, dt, state);
            if (!model.wounds) {  // wounds that were cut know better how wide they stand open
                control.wound_open = hydrodissection_release(*model.hydrodissection, tools,
                                                             eye_pressure(chamber, state.chamber->eye_volume));
            }
        }
        if (model.globe && chamber.leak_conductance > 0.0) {
            control.wound_open = std::min(
                widest_open, control.wound_open + pressed_open(model, tools, state) / chamber.leak_conductance);
        }
        state.flows = advance_chamber(chamber, control, dt, *state.chamber);
        heat_wound(hand >= 0 && model.tools[hand].kind == ToolKind::phaco ? tools[hand].power : 0.0,
                   std::max(0.0, state.flows.infusion), dt, state.chamber->wound);
        if (model.wounds) {
            share_leak(model, tools, dt, state);
        }
        const double shift = lens_shift(model, state);
        for (BagState& bag : state.bags) {
            bag.cushion_z = shift;
        }
        if (hand >= 0 && tools[hand].aspiration > 0.0) {
            TipState& tip = state.tips[hand];
            tip.flow = std::max(0.0, state.flows.tip);
            const double before =
                eye_pressure(chamber, state.chamber->eye_volume) - tube_pressure(chamber, state.chamber->tube_volume);
            // What the flow loses in the tubing does not pull at the mouth.
            tip.suction = std::max(0.0, before - state.flows.tip * chamber.tube_resistance);
            tip.hold = tip.suction * probes[hand].area * (1.0 - tip.open);
        }
        if (model.hydrodissection) {
            strain_by_trapped(model, dt, state);
        }
        if (model.cortex) {
            strip_cortex(model, tools, probes, dt, state);
        }
        if (model.retained) {
            remove_viscoelastic(model, tools, probes, dt, state);
        }
        if (model.vitreous) {
            move_vitreous(model, tools, probes, dt, state);
        }
    }
    if (model.iris) {
        move_iris(model, tools, probes, dt, state);
        if (model.prolapse) {
            move_prolapse(model, tools, dt, state);
        }
    }
}

void add_drag(const WorldModel& model, const WorldState& state, int solid, std::span<const ToolState> tools,
              std::span<const MouthProbe> probes, std::vector<Vec3>& forces) {
    const SolidModel& body = model.solids[solid];
    const SolidState& now = state.solids[solid];
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const double flow = state.tips[i].flow;
        if (!(flow > 0.0)) {
            continue;
        }
        forces.resize(now.position.size(), Vec3::Zero());
        const Vec3 mouth = tools[i].pose.to_world(probes[i].mouth.centre);
        for (std::size_t t = 0; t < body.coarse.tets.size(); ++t) {
            const std::array<int, 4>& tet = body.coarse.tets[t];
            const Vec3 place = centroid(now.position, tet);
            if (now.present[t] == 0 || (place - mouth).squaredNorm() > drawn * drawn) {
                continue;
            }
            const int whole = static_cast<int>(t);
            const double mass = tet_mass(body, whole) * remaining_fraction(body, now, whole);
            const Vec3 share = 0.25 * body.damping_mass * mass * inflow(mouth, flow, model.tools[i].bore_radius, place);
            for (const int node : tet) {
                forces[node] += share;
            }
        }
    }
}

}  // namespace rhexis
