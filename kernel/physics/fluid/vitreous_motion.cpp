// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/fluid/vitreous_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rhexis {

namespace {

constexpr double narrow_gap = 45.0;  ///< between zonules, through which no vitreous comes [degrees]. Proposal
constexpr double mouth_reach = 0.4;  ///< of a mouth beyond what hangs in front [mm]. Proposal
constexpr double gap_reach = 2.0;    ///< the same round the edge of the lens, where no mouth can go [mm]. Proposal
constexpr double wholly = 2.0;       ///< volume that fills a mouth [mm^3]. Proposal
constexpr double shuts = 0.7;        ///< share of a mouth that uncut vitreous shuts. Proposal
constexpr double shuts_cut = 0.2;    ///< and what is cut in it. Proposal
constexpr double full_rate = 0.2;    ///< cut rate, share of the fastest, from which all that flows in is cut. Proposal
constexpr double rate_for_half = 1.0 / 16.0;  ///< cut rate, share of the fastest, that halves the pull. Proposal
constexpr double uncut_draw =
    0.5;  ///< share of the flow into a mouth full of uncut vitreous that is vitreous. Proposal
constexpr double resting_pull = 0.25;   ///< share of what a mouth holds that pulls while it stays. Proposal
constexpr double most_forward = 150.0;  ///< before each opening [mm^3]
constexpr double half_entrained =
    100.0;                           ///< volume in front of which half of what leaves the wound is [mm^3]. Proposal
constexpr double stain_dose = 5.0;   ///< triamcinolone that makes most of it white [mm^3]. Proposal
constexpr double wash = 0.002;       ///< of a plug by 20 ml/min of irrigation [1/s]: dispersive. Proposal
constexpr double plug_draw = 0.05;   ///< share of the flow into a mouth beside a plug that is taken from it. Proposal
constexpr double filled_draw = 0.3;  ///< of what else lies in the chamber, beside its share of it: dispersive. Proposal
constexpr double at_opening = 0.3;   ///< of an opening: suction of a mouth so near acts on the hyaloid [mm]. Proposal
constexpr double least_strand = 1e-3;  ///< less than this is none [mm^3]

bool in_main_wound(const ToolState& tool, const MouthProbe& probe) { return tool.present && !probe.points.empty(); }

double distance_to_segment(const Vec3& a, const Vec3& b, const Vec3& place) {
    const Vec3 line = b - a;
    const double square = line.squaredNorm();
    const double share = square > 0.0 ? std::clamp((place - a).dot(line) / square, 0.0, 1.0) : 0.0;
    return (place - a - share * line).norm();
}

/// What a mouth finds of the vitreous.
struct Found {
    double share = 0.0;  ///< of it that vitreous fills
    int opening = -1;    ///< before which it lies; -1: in the strand to the wound
};

/// The ball that what came forward fills, which stands on its opening.
Vec3 head_of(const WayForward& way, double radius) { return way.place + radius * Vec3::UnitZ(); }

Found find_vitreous(const VitreousModel& model, const VitreousState& vitreous,
                    const std::array<WayForward, opening_count>& ways, const Vec3& mouth) {
    Found best;
    for (std::size_t i = 0; i < opening_count; ++i) {
        const double radius = vitreous_radius(vitreous.front[i]);
        const double off = (mouth - head_of(ways[i], radius)).norm() - radius;
        const double far = i == zonule_gap ? gap_reach : mouth_reach;
        double share = vitreous.front[i] > least_strand && off < far ? std::min(1.0, vitreous.front[i] / wholly) : 0.0;
        const bool behind = vitreous.broken && ways[i].area > 0.0 && mouth.z() < ways[i].place.z() &&
                            (mouth - ways[i].place).head<2>().norm() < ways[i].radius;
        share = behind ? 1.0 : share;
        if (share > best.share) {
            best = {share, static_cast<int>(i)};
        }
    }
    if (vitreous.wound > least_strand && best.share == 0.0) {
        const bool hole = ways[capsule_hole].area > 0.0;
        const Vec3& root = hole ? ways[capsule_hole].place : ways[zonule_gap].place;
        if (distance_to_segment(root, model.wound, mouth) < mouth_reach + vitreous_radius(vitreous.wound)) {
            best = {std::min(1.0, vitreous.wound / wholly), -1};
        }
    }
    return best;
}

Vec3 mouth_of(const ToolState& tool, const MouthProbe& probe) { return tool.pose.to_world(probe.mouth.centre); }

bool cuts(const ToolModel& model, const ToolState& tool) { return model.kind == ToolKind::cutter && tool.power > 0.0; }

void give(const VitreousModel& model, const std::array<WayForward, opening_count>& ways, const Vec3& place,
          double volume, VitreousState& vitreous) {
    vitreous.given += volume;
    std::size_t nearest = opening_count;
    double distance = model.near;
    for (std::size_t i = 0; i < opening_count; ++i) {
        const double off = (place - ways[i].place).norm();
        if (ways[i].area > 0.0 && off < distance) {
            nearest = i;
            distance = off;
        }
    }
    double& store = nearest < opening_count ? vitreous.plug[nearest] : vitreous.filled;
    const double room = model.chamber_volume * (1.0 - filled_share(model, vitreous));
    store += std::min(volume, room);  // the rest comes out of the wound again
}

void stain(double volume, VitreousState& vitreous) {
    vitreous.checked += volume;
    vitreous.marked += (1.0 - vitreous.marked) * std::min(1.0, volume / stain_dose);
}

/// What has come forward is not stained yet.
void come_forward(std::size_t opening, double volume, VitreousState& vitreous) {
    const double more = std::min(volume, most_forward - vitreous.front[opening]);
    if (!(more > 0.0)) {
        return;
    }
    const double before = vitreous_in_front(vitreous) + vitreous.wound;
    vitreous.front[opening] += more;
    vitreous.marked *= before / (before + more);
    vitreous.checked = more > least_strand ? 0.0 : vitreous.checked;
}

/// Tension of the hyaloid by a mouth that sucks at it [uN/mm].
double sucked_tension(const WorldModel& model, const WorldState& state, const WayForward& way,
                      std::span<const ToolState> tools, std::span<const MouthProbe> probes) {
    double tension = 0.0;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (!in_main_wound(tools[i], probes[i]) || !(way.area > 0.0)) {
            continue;
        }
        const Vec3 off = mouth_of(tools[i], probes[i]) - way.place;
        if (off.z() < at_opening && off.head<2>().norm() < way.radius) {
            tension = std::max(tension, 0.5 * state.tips[i].suction * model.tools[i].bore_radius);
        }
    }
    return tension;
}

void press_forward(const WorldModel& model, const std::array<WayForward, opening_count>& ways,
                   std::span<const ToolState> tools, std::span<const MouthProbe> probes, double dt, WorldState& state) {
    const VitreousModel& own = *model.vitreous;
    VitreousState& vitreous = *state.vitreous;
    const double pressure = eye_pressure(*model.chamber, state.chamber->eye_volume);
    const double rate = dt / own.lag;
    vitreous.behind = (vitreous.behind + rate * (pressure + own.push)) / (1.0 + rate);
    const double drive = std::max(0.0, vitreous.behind - std::min(pressure, state.flows.lowest_eye_pressure));
    vitreous.drive = 0.0;
    for (std::size_t i = 0; i < opening_count; ++i) {
        if (!(ways[i].area > 0.0)) {
            continue;
        }
        const double held = own.held_back * covered_share(own, vitreous.plug[i], ways[i].area);
        const double here = drive * (1.0 - held);
        vitreous.drive = i == capsule_hole ? here : vitreous.drive;
        const double tension =
            std::max(0.5 * here * ways[i].radius, sucked_tension(model, state, ways[i], tools, probes));
        vitreous.broken = vitreous.broken || tension > own.hyaloid_strength;
        if (vitreous.broken) {
            come_forward(i, own.mobility * ways[i].area * here * dt, vitreous);
        }
    }
}

void let_go(VitreousState& vitreous) {
    vitreous.tool = -1;
    vitreous.traction = 0.0;
}

/// What a mouth takes of the vitreous, and how it pulls.
void meet_mouth(const WorldModel& model, const std::array<WayForward, opening_count>& ways, int tool,
                const ToolState& tool_state, const MouthProbe& probe, double dt, WorldState& state) {
    VitreousState& vitreous = *state.vitreous;
    const TipState& tip = state.tips[static_cast<std::size_t>(tool)];
    const Vec3 mouth = mouth_of(tool_state, probe);
    const Found found = find_vitreous(*model.vitreous, vitreous, ways, mouth);
    if (!(found.share > 0.0) || !(tip.flow > 0.0)) {
        if (vitreous.tool == tool) {
            let_go(vitreous);
        }
        return;
    }
    if (vitreous.tool != tool) {
        vitreous.tool = tool;
        vitreous.caught = mouth;
    }
    const bool cutting = cuts(model.tools[static_cast<std::size_t>(tool)], tool_state);
    const double rate = cutting ? tool_state.power : 0.0;
    if (cutting) {
        vitreous.caught = mouth;
        double& store = found.opening < 0 ? vitreous.wound : vitreous.front[static_cast<std::size_t>(found.opening)];
        const double taken = std::min(store, found.share * tip.flow * std::min(1.0, rate / full_rate) * dt);
        store = store - taken < least_strand ? 0.0 : store - taken;
        vitreous.cut += taken;
        vitreous.checked = taken > 0.0 ? 0.0 : vitreous.checked;
    } else if (found.opening >= 0 && vitreous.broken) {
        come_forward(static_cast<std::size_t>(found.opening), uncut_draw * found.share * tip.flow * dt, vitreous);
    }
    const double hold = found.share * tip.suction * probe.area / (1.0 + rate / rate_for_half);
    const double pulled = model.vitreous->strand_stiffness * (mouth - vitreous.caught).norm();
    vitreous.traction = std::min(hold, resting_pull * hold + pulled);
    vitreous.peak_traction = std::max(vitreous.peak_traction, vitreous.traction);
    if (pulled > hold) {
        vitreous.caught = mouth;  // it slips, and is caught again
    }
}

/// What the fluid takes along where it leaves the wound.
void follow_leak(const VitreousModel& model, const ChamberFlows& flows, double dt, VitreousState& vitreous) {
    if (!(vitreous.open_s > 0.0)) {
        return;
    }
    vitreous.open_s = std::max(0.0, vitreous.open_s - dt);
    const double front = vitreous_in_front(vitreous);
    if (!(front > 0.0)) {
        return;
    }
    const double freely = 1.0 - filled_share(model, vitreous);
    const double moved = std::min(front, std::max(0.0, flows.leak) * front / (front + half_entrained) * freely * dt);
    for (double& volume : vitreous.front) {
        volume -= moved * volume / front;
    }
    vitreous.wound += moved;
}

void wash_out(const WorldModel& model, const std::array<WayForward, opening_count>& ways,
              std::span<const ToolState> tools, std::span<const MouthProbe> probes, double dt, WorldState& state) {
    VitreousState& vitreous = *state.vitreous;
    const double washed = 1.0 / (1.0 + wash * std::max(0.0, state.flows.infusion) / usual_flow * dt);
    for (double& plug : vitreous.plug) {
        plug *= washed;
    }
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const double flow = state.tips[i].flow * dt;
        if (!in_main_wound(tools[i], probes[i]) || !(flow > 0.0)) {
            continue;
        }
        for (std::size_t k = 0; k < opening_count; ++k) {
            if ((mouth_of(tools[i], probes[i]) - ways[k].place).norm() < model.vitreous->near) {
                vitreous.plug[k] = std::max(0.0, vitreous.plug[k] - plug_draw * flow);
            }
        }
        vitreous.filled =
            std::max(0.0, vitreous.filled -
                              filled_draw * flow * std::min(1.0, vitreous.filled / model.vitreous->chamber_volume));
    }
}

/// Between the edge of the bag and the ciliary body, where no zonule is left; a narrow gap lets nothing through.
WayForward gap_way(const BagModel& model, const BagState& state) {
    const ZonuleGap gap = widest_gap(model, *state.zonules);
    if (gap.width_deg < narrow_gap) {
        return {};
    }
    const Vec3 edge = state.pose.to_world(model.shape.radius * gap.middle);
    double ciliary = 0.0;
    for (const ZonuleSpring& spring : model.zonules) {
        ciliary = std::max(ciliary, spring.on_ciliary.head<2>().norm());
    }
    const double width = std::max(0.0, ciliary - edge.head<2>().norm());
    const double arc = gap.width_deg * std::numbers::pi / 180.0;
    const double area = 0.5 * arc * (ciliary + edge.head<2>().norm()) * width;
    return {edge + 0.5 * width * gap.middle, area, std::sqrt(area / std::numbers::pi)};
}

}  // namespace

std::array<WayForward, opening_count> ways_forward(const WorldModel& model, const WorldState& state) {
    std::array<WayForward, opening_count> ways;
    if (state.capsule && !state.bags.empty() && state.capsule->hole_radius > 0.0) {
        const double radius = state.capsule->hole_radius;
        ways[capsule_hole] = {state.bags[0].pose.to_world(state.capsule->hole_place),
                              std::numbers::pi * radius * radius, radius};
    }
    if (!state.bags.empty() && state.bags[0].zonules) {
        ways[zonule_gap] = gap_way(model.bags[0], state.bags[0]);
    }
    return ways;
}

void lay_viscoelastic(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                      double dt, WorldState& state) {
    const VitreousModel& own = *model.vitreous;
    VitreousState& vitreous = *state.vitreous;
    const std::array<WayForward, opening_count> ways = ways_forward(model, state);
    bool inside = false;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (model.tools[i].kind == ToolKind::cannula && tools[i].present && tools[i].jaw > 0.0) {
            const double pressure = eye_pressure(*model.chamber, state.chamber->eye_volume);
            const double eased = std::clamp(1.0 - pressure / own.most_pressure, 0.0, 1.0);
            const double volume = own.injection * tools[i].jaw * eased * dt;
            state.chamber->eye_volume += volume;
            if (model.tools[i].stains) {
                stain(volume, vitreous);
            } else {
                give(own, ways, tools[i].pose.position, volume, vitreous);
            }
        }
        if (!in_main_wound(tools[i], probes[i])) {
            continue;
        }
        inside = true;
        const Found found = find_vitreous(own, vitreous, ways, mouth_of(tools[i], probes[i]));
        state.tips[i].open *= 1.0 - found.share * (cuts(model.tools[i], tools[i]) ? shuts_cut : shuts);
    }
    if (!inside && vitreous.inside > 0.0) {
        vitreous.open_s = own.gape_s;
    }
    vitreous.inside = inside ? 1.0 : 0.0;
}

double wound_release(const VitreousModel& model, const VitreousState& state, double open) {
    const double gaping = state.open_s > 0.0 ? model.gape : open;
    return gaping * (1.0 - filled_share(model, state));
}

void move_vitreous(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                   double dt, WorldState& state) {
    const std::array<WayForward, opening_count> ways = ways_forward(model, state);
    press_forward(model, ways, tools, probes, dt, state);
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (in_main_wound(tools[i], probes[i])) {
            meet_mouth(model, ways, static_cast<int>(i), tools[i], probes[i], dt, state);
        } else if (state.vitreous->tool == static_cast<int>(i)) {
            let_go(*state.vitreous);
        }
    }
    follow_leak(*model.vitreous, state.flows, dt, *state.vitreous);
    wash_out(model, ways, tools, probes, dt, state);
}

}  // namespace rhexis
