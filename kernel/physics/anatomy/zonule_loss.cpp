// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/zonule_loss.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

namespace {

double rim_height(const BagShape& shape, double opening) {
    const double share = opening / shape.radius;
    return shape.anterior * std::sqrt(std::max(0.0, 1.0 - share * share));
}

/// The place of the edge that is nearest, in the bag's frame [mm].
Vec3 nearest_on_rim(const BagModel& bag, const Vec3& place) {
    const double rho = std::sqrt(place.x() * place.x() + place.y() * place.y());
    const double scale = rho > 0.0 ? bag.opening_radius / rho : 0.0;
    return {rho > 0.0 ? scale * place.x() : bag.opening_radius, scale * place.y(),
            rim_height(bag.shape, bag.opening_radius)};
}

void break_most_stretched(const BagModel& bag, BagState& state) {
    std::size_t worst = bag.zonules.size();
    double most = bag.breakable->breaks_at;
    for (std::size_t i = 0; i < bag.zonules.size(); ++i) {
        const ZonuleSpring& spring = bag.zonules[i];
        const double rest = (spring.on_bag - spring.on_ciliary).norm();
        const double stretch = zonule_strain(spring, state.pose) * rest;
        if (state.zonules->broken[i] == 0 && stretch > most) {
            most = stretch;
            worst = i;
        }
    }
    if (worst < bag.zonules.size()) {
        state.zonules->broken[worst] = 1;
    }
}

void set_hook(const BagModel& bag, const Vec3& tip, BagState& state) {
    const ZonuleModel& own = *bag.breakable;
    if (state.zonules->hooks.size() >= own.most_hooks || distance_to_rim(bag, tip) > own.hook_reach) {
        return;
    }
    CapsuleHook hook;
    hook.on_bag = nearest_on_rim(bag, tip);
    const Vec3 place = state.pose.to_world(hook.on_bag);
    const double rho = std::sqrt(place.x() * place.x() + place.y() * place.y());
    if (!(rho > 0.0)) {
        return;
    }
    const double scale = own.limbus_radius / rho;
    hook.at_limbus = Vec3(scale * place.x(), scale * place.y(), own.limbus_z);
    hook.length = (hook.at_limbus - place).norm();
    state.zonules->hooks.push_back(hook);
}

}  // namespace

double distance_to_rim(const BagModel& bag, const Vec3& place) { return (nearest_on_rim(bag, place) - place).norm(); }

void tend_zonules(const BagModel& bag, std::span<const ToolModel> models, std::span<const ToolState> tools, double dt,
                  BagState& state) {
    break_most_stretched(bag, state);
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const ToolState& tool = tools[i];
        if (!tool.present) {
            continue;
        }
        const Vec3 tip = state.pose.to_body(tool.pose.position);
        if (models[i].kind == ToolKind::capsule_hook && tool.previous_jaw > closed_jaw && tool.jaw <= closed_jaw) {
            set_hook(bag, tip, state);
        } else if (models[i].kind == ToolKind::ring && tool.jaw > 0.0 && state.zonules->ring < 1.0 &&
                   distance_to_rim(bag, tip) <= bag.breakable->hook_reach) {
            double& fed = state.zonules->ring;
            fed = std::max(fed, std::min(tool.jaw, fed + dt / bag.breakable->ring_s));
        }
    }
}

}  // namespace rhexis
