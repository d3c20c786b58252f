// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/fluid/debris_motion.hpp"

#include <algorithm>
#include <cmath>

#include "physics/contact/rigid_partner.hpp"
#include "physics/fluid/fluid_step.hpp"

namespace rhexis {

namespace {

constexpr double drag = 60.0;            ///< share of the difference to the fluid's velocity lost [1/s]. Proposal
constexpr double fits = 0.9;             ///< of the bore: what is narrower goes through
constexpr double gulp = 0.15;            ///< in front of the mouth from which debris is drawn into it [mm]
constexpr double debris_substep = 1e-3;  ///< [s]
constexpr double least_debris = 1e-6;    ///< less is gone [mm^3]

Vec3 fluid_velocity(const WorldModel& model, const WorldState& state, std::span<const ToolState> tools,
                    std::span<const MouthProbe> probes, const Vec3& place) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const Vec3 mouth = tools[i].pose.to_world(probes[i].mouth.centre);
        if (state.tips[i].flow > 0.0 && (place - mouth).squaredNorm() < drawn * drawn) {
            sum += inflow(mouth, state.tips[i].flow, model.tools[i].bore_radius, place);
        }
    }
    return sum;
}

/// Back onto the side of a wall on which it is; what moved into it stops.
void push_out(const Vec3& normal, double depth, Debris& crumb) {
    if (depth > 0.0) {
        crumb.position += depth * normal;
        crumb.velocity -= std::min(0.0, normal.dot(crumb.velocity)) * normal;
    }
}

void stay_in(const WorldModel& model, const WorldState& state, Debris& crumb) {
    const double radius = radius_of(crumb);
    for (const DomeModel& dome : model.domes) {
        const Vec3 out = crumb.position - dome.centre;
        const double distance = out.norm();
        push_out(-out / std::max(distance, 1e-9), distance + radius - dome.radius, crumb);
    }
    for (std::size_t b = 0; b < model.bags.size(); ++b) {
        const BagModel& bag = model.bags[b];
        const Pose& pose = state.bags[b].pose;
        const Vec3 local = pose.to_body(crumb.position);
        const bool in_front = local.z() > 0.0;
        if ((in_front && local.head<2>().squaredNorm() < bag.opening_radius * bag.opening_radius) ||
            (state.capsule && within_hole(*state.capsule, local))) {
            continue;
        }
        const SurfaceDistance wall = bag_distance(bag.shape, local);
        const Vec3 normal = pose.orientation * wall.normal;
        if (wall.distance > 0.0) {
            const bool before_zonules = local.z() > -radius;
            const SurfaceDistance outer = before_zonules ? wall_distance(bag, local, {.outside = true}) : wall;
            push_out(pose.orientation * outer.normal, radius - outer.distance, crumb);
        } else {
            push_out(-normal, radius + wall.distance, crumb);
        }
    }
}

void drift(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes, double dt,
           const WorldState& state, Debris& crumb) {
    const double fluid = model.solids.empty() ? 1.0e-3 : model.solids[0].buoyancy_density;
    const Vec3 weight = (1.0 - fluid / crumb.density) * model.gravity;
    const int count = std::max(1, static_cast<int>(std::lround(dt / debris_substep)));
    const double h = dt / count;
    for (int i = 0; i < count; ++i) {
        const Vec3 flow = fluid_velocity(model, state, tools, probes, crumb.position);
        crumb.velocity = (crumb.velocity + h * (drag * flow + weight)) / (1.0 + h * drag);
        crumb.position += h * crumb.velocity;
        stay_in(model, state, crumb);
    }
}

/// What a tip does to debris in its mouth: holds it, emulsifies it, or takes it in.
void take_in(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes, double dt,
             WorldState& state, Debris& crumb) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const ToolModel& tool = model.tools[i];
        if (probes[i].points.empty() || !tools[i].present || !(tools[i].aspiration > 0.0)) {
            continue;
        }
        const Vec3 mouth = tools[i].pose.to_world(probes[i].mouth.centre);
        const double near = tool.bore_radius + radius_of(crumb) + gulp;
        if ((crumb.position - mouth).squaredNorm() > near * near) {
            continue;
        }
        double lost = 0.0;
        if (radius_of(crumb) < fits * tool.bore_radius) {
            lost = crumb.volume;
        } else {
            crumb.position = mouth + (tools[i].pose.orientation * probes[i].mouth.facing) * radius_of(crumb);
            crumb.velocity = tools[i].velocity;
            const double energy = tools[i].power * tool.max_power * dt;
            lost = crumb.ablation_energy > 0.0 ? std::min(crumb.volume, energy / crumb.ablation_energy) : 0.0;
            state.ablation_energy += lost * crumb.ablation_energy;
        }
        crumb.volume -= lost;
        state.removed_mass += lost * crumb.density;
    }
}

}  // namespace

bool shuts(const Debris& debris, const ToolModel& tool, const Vec3& mouth) {
    const double radius = radius_of(debris);
    const double near = tool.bore_radius + radius + gulp;
    return radius >= fits * tool.bore_radius && (debris.position - mouth).squaredNorm() <= near * near;
}

void move_debris(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                 double dt, WorldState& state) {
    for (Debris& crumb : state.debris) {
        drift(model, tools, probes, dt, state, crumb);
        take_in(model, tools, probes, dt, state, crumb);
    }
    for (const Debris& crumb : state.debris) {
        state.removed_mass += crumb.volume < least_debris ? crumb.volume * crumb.density : 0.0;
    }
    std::erase_if(state.debris, [](const Debris& crumb) { return crumb.volume < least_debris; });
}

}  // namespace rhexis
