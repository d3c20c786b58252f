// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/sheet_grip.hpp"

#include <algorithm>
#include <cmath>

#include "physics/sheet_contact.hpp"

namespace rhexis {
namespace {

constexpr double lost_at = 2.0;  ///< times their reach from the middle of the jaws: it has slipped out

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Its front looks against where it looked at rest.
bool folded(const MembraneState& state, int triangle) {
    const std::array<int, 3>& n = state.sheet->mesh.triangles[at(triangle)];
    const Vec3& a = state.position[at(n[0])];
    const Vec3 now = (state.position[at(n[1])] - a).cross(state.position[at(n[2])] - a);
    return now.dot(front_of(state.sheet->mesh, triangle)) < 0.0;
}

/// Nodes of the triangles that come within reach of a place, ascending.
std::vector<int> between_jaws(const MembraneState& state, const Vec3& place, double reach) {
    std::vector<int> plain;
    std::vector<int> over;
    for (int t = 0; t < static_cast<int>(state.sheet->mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = state.sheet->mesh.triangles[at(t)];
        const std::array<Vec3, 3> x{state.position[at(n[0])], state.position[at(n[1])], state.position[at(n[2])]};
        const std::array<double, 3> w = nearest_to_segment(x, place, place);
        if ((w[0] * x[0] + w[1] * x[1] + w[2] * x[2] - place).norm() < reach) {
            std::vector<int>& list = folded(state, t) ? over : plain;
            list.insert(list.end(), n.begin(), n.end());
        }
    }
    std::vector<int>& held = over.empty() ? plain : over;
    std::sort(held.begin(), held.end());
    held.erase(std::unique(held.begin(), held.end()), held.end());
    return held;
}

}  // namespace

void move_jaws(const WorldModel& world, std::span<const ToolState> tools, MembraneState& state) {
    for (int k = 0; k < static_cast<int>(tools.size()); ++k) {
        const ToolState& tool = tools[at(k)];
        if (world.tools[at(k)].kind != ToolKind::forceps) {
            continue;
        }
        if (!tool.present || tool.jaw > closed_jaw) {
            std::erase_if(state.grips, [k](const SheetGrip& grip) { return grip.tool == k; });
        } else if (tool.previous_jaw > closed_jaw) {
            const Pose& pose = tool.previous_pose;
            for (const int node : between_jaws(state, pose.position, world.tools[at(k)].reach)) {
                state.grips.push_back({k, node, pose.to_body(state.position[at(node)])});
            }
        }
    }
}

void SheetGrips::look(const WorldModel& world, int membrane, const MembraneState& state, double stiffness) {
    world_ = &world;
    membrane_ = membrane;
    stiffness_ = stiffness;
    grips_ = state.grips;
    impulse_.assign(grips_.size(), Vec3::Zero());
    point_.assign(grips_.size(), Vec3::Zero());
    nodes_of_.assign(world.tools.size(), 0);
    for (const SheetGrip& grip : grips_) {
        ++nodes_of_[at(grip.tool)];
    }
}

/// What the jaws bear at one of the nodes that they hold.
double SheetGrips::most(const SheetGrip& grip) const {
    return world_->tools[at(grip.tool)].hold / nodes_of_[at(grip.tool)];
}

SheetGrips::Pull SheetGrips::pull(const SheetGrip& grip, const std::vector<Vec3>& position,
                                  const PartnerPoses& poses) const {
    const Vec3 way = poses.tools[at(grip.tool)].to_world(grip.place) - position[at(grip.node)];
    const double wanted = stiffness_ * way.norm();
    const double limit = most(grip);
    if (wanted <= limit) {
        return {stiffness_ * way, stiffness_ * Mat3::Identity()};
    }
    const Vec3 along = way.normalized();
    return {limit * along, limit / way.norm() * (Mat3::Identity() - along * along.transpose())};
}

void SheetGrips::terms(const std::vector<Vec3>& position, const PartnerPoses& poses,
                       std::vector<ContactTerm>& terms) const {
    for (const SheetGrip& grip : grips_) {
        const Pull p = pull(grip, position, poses);
        ContactTerm& term = terms.emplace_back();
        term.nodes[0] = grip.node;
        term.force = p.force;
        term.stiffness = p.stiffness;
    }
}

void SheetGrips::settle(const std::vector<Vec3>& position, const PartnerPoses& poses, double dt) {
    for (std::size_t i = 0; i < grips_.size(); ++i) {
        SheetGrip& grip = grips_[i];
        const Pose& pose = poses.tools[at(grip.tool)];
        const Vec3 force = pull(grip, position, poses).force;
        impulse_[i] += dt * force;
        point_[i] = position[at(grip.node)];
        // what pulls harder slips until it does not
        grip.place = pose.to_body(point_[i] + force / stiffness_);
    }
}

std::vector<SheetGrip> SheetGrips::kept() const {
    std::vector<SheetGrip> result = grips_;
    std::erase_if(result, [&](const SheetGrip& grip) {
        return grip.place.norm() > lost_at * world_->tools[at(grip.tool)].reach;
    });
    return result;
}

void SheetGrips::report(double dt, ContactSet& contacts) const {
    for (std::size_t i = 0; i < grips_.size(); ++i) {
        Contact& contact = contacts.emplace_back();
        contact.solid = -1;
        contact.membrane = membrane_;
        contact.nodes[0] = grips_[i].node;
        contact.partner = ContactPartner::tool;
        contact.partner_index = grips_[i].tool;
        contact.point = point_[i];
        contact.force = impulse_[i] / dt;
    }
}

}  // namespace rhexis
