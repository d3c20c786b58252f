// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane/sheet_grip.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/index.hpp"
#include "mesh/nearest_place.hpp"
#include "physics/membrane/needle.hpp"

namespace rhexis {
namespace {

constexpr double slipped_at = 2.0;  ///< times their reach from the middle of the jaws: it has slipped out

constexpr double beside_tip = 0.8;  ///< of a needle from the end of a tear, at rest [mm]

constexpr double gape = 0.15;        ///< of the lips of a slit about a needle [mm]
constexpr double least_ahead = 0.1;  ///< cosine of the way from there to the needle to that of the tear

/// Nodes of the triangles that come within reach of a place, ascending.
std::vector<int> between_jaws(const MembraneState& state, const Vec3& place, double reach) {
    std::vector<int> plain;
    std::vector<int> over;
    for (int t = 0; t < static_cast<int>(state.sheet->mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = state.sheet->mesh.triangles[at(t)];
        const std::array<Vec3, 3> x{state.position[at(n[0])], state.position[at(n[1])], state.position[at(n[2])]};
        const std::array<double, 3> w = nearest_to_point(x, place);
        if ((place_in(x, w) - place).norm() < reach) {
            std::vector<int>& list = folded(state, t) ? over : plain;
            list.insert(list.end(), n.begin(), n.end());
        }
    }
    std::vector<int>& held = over.empty() ? plain : over;
    std::sort(held.begin(), held.end());
    held.erase(std::unique(held.begin(), held.end()), held.end());
    return held;
}

void let_go(int tool, MembraneState& state) {
    std::erase_if(state.grips, [tool](const SheetGrip& grip) { return grip.tool == tool; });
}

void close_jaws(const ToolModel& model, const ToolState& tool, int index, MembraneState& state) {
    if (!tool.present || tool.jaw > closed_jaw) {
        let_go(index, state);
    } else if (tool.previous_jaw > closed_jaw) {
        const Pose& pose = tool.previous_pose;
        for (const int node : between_jaws(state, pose.position, model.reach)) {
            state.grips.push_back({index, node, pose.to_body(state.position[at(node)])});
        }
    }
}

/// The end of a tear that a needle stands at, in the sheet beyond it; -1: none.
int tip_at(const Vec3& place_at_rest, const MembraneState& state) {
    int found = -1;
    double least = beside_tip;
    for (const TearTip& tip : state.tips) {
        const Vec3 way = place_at_rest - state.sheet->mesh.nodes[at(tip.node)];
        const double distance = way.norm();
        if (distance < least && way.dot(tip.direction) > least_ahead * distance) {
            least = distance;
            found = tip.node;
        }
    }
    return found;
}

void hook(const ToolModel& model, const ToolState& tool, int index, MembraneState& state) {
    let_go(index, state);
    const std::optional<NeedleLip> lip = tool.present ? lip_of(model, tool, state) : std::nullopt;
    if (!lip || !lip->beyond) {
        return;
    }
    if (const int tip = tip_at(lip->needle, state); tip >= 0) {
        state.grips.push_back({index, tip, Vec3::Zero(), true, 0.0});
        return;
    }
    for (const int node : lip->nodes) {
        state.grips.push_back({index, node, Vec3::Zero(), true, gape});
    }
}

}  // namespace

std::vector<int> take_hold(const WorldModel& world, std::span<const ToolState> tools, MembraneState& state) {
    std::vector<int> out;
    for (const SheetGrip& grip : state.grips) {
        if (!grip.pushed && !tools[at(grip.tool)].present) {
            out.push_back(grip.node);
        }
    }
    for (int k = 0; k < static_cast<int>(tools.size()); ++k) {
        const ToolModel& model = world.tools[at(k)];
        if (model.kind == ToolKind::forceps) {
            close_jaws(model, tools[at(k)], k, state);
        } else if (model.kind == ToolKind::cystotome) {
            hook(model, tools[at(k)], k, state);
        }
    }
    return out;
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
    const Pose& pose = poses.tools[at(grip.tool)];
    Vec3 way = pose.to_world(grip.place) - position[at(grip.node)];
    Mat3 led = Mat3::Identity();
    if (grip.pushed) {
        const Vec3 needle = pose.orientation * Vec3::UnitZ();
        led -= needle * needle.transpose();
        way = led * way;
        const double length = way.norm();
        if (length <= grip.slack) {
            return {};
        }
        const Vec3 along = way / length;
        const double share = (length - grip.slack) / length;
        led = share * led + (1.0 - share) * along * along.transpose();
        way *= share;
    }
    const double wanted = stiffness_ * way.norm();
    const double limit = most(grip);
    if (wanted <= limit) {
        return {stiffness_ * way, stiffness_ * led};
    }
    const Vec3 ahead = way.normalized();
    return {limit * ahead, limit / way.norm() * (led - ahead * ahead.transpose())};
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
        if (!grip.pushed) {
            grip.place = pose.to_body(point_[i] + force / stiffness_);  // what pulls harder slips until it does not
        }
    }
}

std::vector<SheetGrip> SheetGrips::kept() const {
    std::vector<SheetGrip> result = grips_;
    std::erase_if(result, [&](const SheetGrip& grip) {
        return !grip.pushed && grip.place.norm() > slipped_at * world_->tools[at(grip.tool)].reach;
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
