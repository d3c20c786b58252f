// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/bag_contents.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace rhexis {

namespace {

constexpr double adherent_shuts = 0.95;  ///< share of a mouth that adherent cortex shuts. Proposal
constexpr double loose_shuts = 0.4;      ///< and cortex that was stripped. Proposal
constexpr double sideways = -0.2;        ///< cosine to a mouth's normal from which it draws cortex. Proposal
constexpr double close_by = 0.3;  ///< cortex so near, or loose, comes whichever way the mouth looks [mm]. Proposal
constexpr double none = 1e-4;     ///< less than this is none [mm^3]

Vec3 mouth_of(const ToolState& tool, const MouthProbe& probe) { return tool.pose.to_world(probe.mouth.centre); }

bool aspirates(const ToolState& tool, const MouthProbe& probe) {
    return tool.present && !probe.points.empty() && tool.aspiration > 0.0;
}

void let_go(CortexState& cortex) {
    cortex.tool = -1;
    cortex.cell = -1;
    cortex.held = false;
    cortex.pull.setZero();
}

/// The cortex that a mouth draws at: the nearest within reach that it looks at; or -1.
int cell_before(const WorldModel& model, const WorldState& state, const ToolState& tool, const MouthProbe& probe) {
    const CortexState& cortex = *state.cortex;
    const Vec3 mouth = mouth_of(tool, probe);
    const Vec3 facing = tool.pose.orientation * probe.mouth.facing;
    int best = -1;
    double nearest = model.cortex->reach;
    for (int cell = 0; cell < cell_count(model.cortex->cells); ++cell) {
        if (!(cortex.volume[at(cell)] > none)) {
            continue;
        }
        const Vec3 way = state.bags[0].pose.to_world(cortex_place(*model.cortex, model.bags[0].shape, cell)) - mouth;
        const double off = way.norm();
        const bool floats = !(cortex.attached[at(cell)] > 0.0);
        if (off < nearest && (floats || off < close_by || facing.dot(way) > sideways * off)) {
            best = cell;
            nearest = off;
        }
    }
    return best;
}

/// A mouth keeps what it holds, and draws loose cortex of the same sector after it.
int next_cell(const CortexModel& model, const CortexState& cortex) {
    const int first = cortex.cell / model.cells.rings * model.cells.rings;
    for (int ring = model.cells.rings - 1; ring >= 0; --ring) {
        if (cortex.volume[at(first + ring)] > none) {
            return first + ring;
        }
    }
    return -1;
}

/// Of the held sector, and in part of those beside it.
void strip(const CortexModel& model, double tension, double dt, CortexState& cortex) {
    const double excess = tension / model.adhesion - 1.0;
    if (!(excess > 0.0)) {
        return;
    }
    const int sector = cortex.cell / model.cells.rings;
    for (const int beside : {-1, 0, 1}) {
        const double share = (beside == 0 ? 1.0 : model.beside) * model.strip_rate * excess * dt;
        const int other = (sector + beside + model.cells.sectors) % model.cells.sectors;
        for (int ring = 0; ring < model.cells.rings; ++ring) {
            double& attached = cortex.attached[at(other * model.cells.rings + ring)];
            attached = std::max(0.0, attached - share);
        }
    }
}

/// Pull on what is held; it slips where suction cannot hold it.
void pull_at(const WorldModel& model, const Vec3& mouth, double hold, double dt, WorldState& state) {
    const CortexModel& own = *model.cortex;
    CortexState& cortex = *state.cortex;
    const Vec3 way = mouth - state.bags[0].pose.to_world(cortex.place);
    const double stretched = std::max(0.0, way.norm() - own.slack);
    const double tension = std::min(hold, own.stiffness * stretched);
    cortex.pull.setZero();
    if (!(cortex.attached[at(cortex.cell)] > 0.0)) {
        return;
    }
    if (stretched > 2.0 * hold / own.stiffness + own.slack) {
        let_go(cortex);
        return;
    }
    if (tension > 0.0) {
        cortex.pull = tension / way.norm() * way;
        strip(own, tension, dt, cortex);
    }
}

void take(const CortexModel& model, double flow, double dt, CortexState& cortex) {
    double& volume = cortex.volume[at(cortex.cell)];
    if (cortex.attached[at(cortex.cell)] > 0.0 || !(volume > none)) {
        return;
    }
    const double taken = std::min(volume, model.draw * flow * dt);
    volume = volume - taken > none ? volume - taken : 0.0;
    cortex.taken += taken;
    if (volume > 0.0) {
        return;
    }
    cortex.cell = next_cell(model, cortex);
    if (cortex.cell < 0 || cortex.attached[at(cortex.cell)] > 0.0) {
        let_go(cortex);
    }
}

/// Viscoelastic about a mouth: what of the flow into it is that.
double drawn(const RetainedViscoelasticModel& model, double volume, double flow, double dt) {
    return std::min(volume, model.draw * flow * volume / (volume + model.whole) * dt);
}

/// How far the tip presses the edge of the optic down: 0 to 1.
double rocking(const RetainedViscoelasticModel& model, const Vec3& end, double radius) {
    const double off = end.head<2>().norm();
    const double pressed = model.optic_z + model.optic_half - (end.z() - radius);
    const bool on_edge = off > 0.5 * model.optic_radius && off < model.optic_radius + 0.2;
    return on_edge && end.z() > model.optic_z ? std::clamp(pressed / model.most_tilt, 0.0, 1.0) : 0.0;
}

bool lies_behind(const RetainedViscoelasticModel& model, const Vec3& mouth) {
    return mouth.head<2>().norm() < model.optic_radius + model.beside && mouth.z() < model.optic_z - model.optic_half &&
           mouth.z() > model.optic_z - model.optic_half - model.under;
}

}  // namespace

void look_for_cortex(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                     WorldState& state) {
    CortexState& cortex = *state.cortex;
    if (cortex.tool >= 0 && !aspirates(tools[at(cortex.tool)], probes[at(cortex.tool)])) {
        let_go(cortex);
    }
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (!aspirates(tools[i], probes[i]) || (cortex.tool >= 0 && cortex.tool != static_cast<int>(i))) {
            continue;
        }
        if (!cortex.held) {
            cortex.cell = cell_before(model, state, tools[i], probes[i]);
            cortex.tool = cortex.cell >= 0 ? static_cast<int>(i) : -1;
        }
        if (cortex.cell >= 0) {
            cortex.place = cortex_place(*model.cortex, model.bags[0].shape, cortex.cell);
            const bool adheres = cortex.attached[at(cortex.cell)] > 0.0;
            state.tips[i].open *= 1.0 - (adheres ? adherent_shuts : loose_shuts);
            return;
        }
    }
}

void strip_cortex(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                  double dt, WorldState& state) {
    CortexState& cortex = *state.cortex;
    if (cortex.tool < 0 || cortex.cell < 0) {
        return;
    }
    const TipState& tip = state.tips[at(cortex.tool)];
    const MouthProbe& probe = probes[at(cortex.tool)];
    cortex.held = tip.suction > model.cortex->holding || (cortex.held && !(cortex.attached[at(cortex.cell)] > 0.0));
    if (!cortex.held) {
        cortex.pull.setZero();
        return;
    }
    pull_at(model, mouth_of(tools[at(cortex.tool)], probe), tip.suction * probe.area, dt, state);
    if (cortex.cell >= 0) {
        take(*model.cortex, tip.flow, dt, cortex);
    }
}

Vec6 contents_load(const WorldModel& model, const WorldState& state, const Pose& bag) {
    Vec6 load = Vec6::Zero();
    const auto add = [&](const Vec3& place, const Vec3& force) {
        load.head<3>() += force;
        load.tail<3>() += (bag.orientation * place).cross(force);
    };
    if (state.cortex && state.cortex->held) {
        add(state.cortex->place, state.cortex->pull);
    }
    if (state.hydrodissection && state.hydrodissection->burst_s >= 0.0) {
        add(state.capsule->hole_place, -sinking_force(*model.hydrodissection, *state.hydrodissection) * Vec3::UnitZ());
    }
    return load;
}

void remove_viscoelastic(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                         double dt, WorldState& state) {
    const RetainedViscoelasticModel& own = *model.retained;
    RetainedViscoelasticState& left = *state.retained;
    left.rocked = 0.0;
    left.under = 0.0;
    const auto take_from = [&](double& store, double volume) {
        const double taken = std::min(store, volume);
        store -= taken;
        left.taken += taken;
    };
    take_from(left.front, left.front * std::min(1.0, own.wash * std::max(0.0, state.flows.infusion) / usual_flow * dt));
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (!tools[i].present || probes[i].points.empty()) {
            continue;
        }
        const Pose& bag = state.bags[0].pose;
        const RoundedCone& end = model.tools[i].parts.front();
        left.rocked = std::max(left.rocked, rocking(own, bag.to_body(tools[i].pose.to_world(end.a)), end.radius_a));
        const bool behind = lies_behind(own, bag.to_body(mouth_of(tools[i], probes[i])));
        left.under = behind ? 1.0 : left.under;
        const double flow = state.tips[i].flow;
        if (behind) {
            take_from(left.behind, drawn(own, left.behind, flow, dt));
            continue;
        }
        take_from(left.behind, left.rocked * own.rocked_draw * drawn(own, left.behind, flow, dt));
        take_from(left.front, drawn(own, left.front, flow, dt));
        take_from(left.angle, own.angle_draw * drawn(own, left.angle, flow, dt));
    }
}

}  // namespace rhexis
