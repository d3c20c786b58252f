// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/sheet_grip.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/needle.hpp"
#include "physics/sheet_contact.hpp"
#include "physics/sheet_layers.hpp"

namespace rhexis {
namespace {

constexpr double lost_at = 2.0;  ///< times their reach from the middle of the jaws: it has slipped out

constexpr double gone_back = 0.4;  ///< of a needle from what it pushed [mm]
constexpr double slid_past = 0.8;  ///< likewise, sideways [mm]

constexpr double in_the_way = 0.3;   ///< of a needle, to its side [mm]
constexpr double just_passed = 0.1;  ///< by a needle [mm]
constexpr double same_way = 0.6;     ///< cosine within which a needle goes on in the way in which it pushes

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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

/// How far a node is ahead of the needle that pushes it [mm].
double ahead_of(const SheetGrip& grip, const Pose& pose, const Vec3& node) {
    return (pose.orientation * grip.push).dot(node - pose.to_world(grip.place));
}

/// Whether a needle still stands behind what it pushes: it is through the sheet there, and has neither gone back nor
/// slid past.
bool stands_behind(const SheetGrip& grip, const ToolState& tool, const MembraneState& state) {
    const Vec3& node = state.position[at(grip.node)];
    const Vec3 own = tool.pose.to_body(node);
    return own.z() > 0.0 && own.head<2>().norm() < slid_past && ahead_of(grip, tool.pose, node) < gone_back;
}

/// A needle pushes a node from where that is now, or from where the needle will meet it.
SheetGrip pushed(int tool, int node, const Vec3& own, const Vec3& way) {
    return {tool, node, std::min(0.0, own.dot(way)) * way, way};
}

/// The end of a tear that a needle comes upon; -1: none.
int tip_ahead(const Pose& needle, const Vec3& way, const MembraneState& state) {
    int found = -1;
    double least = HUGE_VAL;
    for (const TearTip& tip : state.tips) {
        const Vec3 own = needle.to_body(state.position[at(tip.node)]);
        const double ahead = own.dot(way);
        const double aside = (own - ahead * way).head<2>().norm();
        if (own.z() > 0.0 && aside < in_the_way && ahead > -just_passed && ahead < least) {
            least = ahead;
            found = tip.node;
        }
    }
    return found;
}

void hook(const ToolModel& model, const ToolState& tool, int index, MembraneState& state) {
    if (!tool.present) {
        let_go(index, state);
        return;
    }
    Vec3 way = tool.pose.orientation.conjugate() * (tool.pose.position - tool.previous_pose.position);
    way.z() = 0.0;
    const bool moves = way.norm() > 1e-5;
    way = moves ? Vec3(way.normalized()) : Vec3(Vec3::Zero());
    const bool hooked = std::any_of(state.grips.begin(), state.grips.end(), [&](const SheetGrip& grip) {
        return grip.tool == index && stands_behind(grip, tool, state) && (!moves || grip.push.dot(way) > same_way);
    });
    if (hooked) {
        return;
    }
    let_go(index, state);
    const std::optional<NeedleLip> lip = lip_of(model, tool.pose, state);
    if (!lip || !moves) {
        return;
    }
    if (const int tip = tip_ahead(tool.pose, way, state); tip >= 0) {
        state.grips.push_back(pushed(index, tip, tool.pose.to_body(state.position[at(tip)]), way));
    } else if (lip->beyond && lip->inward.dot(tool.pose.orientation * way) > same_way) {
        for (const int node : lip->nodes) {
            state.grips.push_back(pushed(index, node, tool.pose.to_body(state.position[at(node)]), way));
        }
    }
}

}  // namespace

void take_hold(const WorldModel& world, std::span<const ToolState> tools, MembraneState& state) {
    for (int k = 0; k < static_cast<int>(tools.size()); ++k) {
        const ToolModel& model = world.tools[at(k)];
        if (model.kind == ToolKind::forceps) {
            close_jaws(model, tools[at(k)], k, state);
        } else if (model.kind == ToolKind::cystotome) {
            hook(model, tools[at(k)], k, state);
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
    const Pose& pose = poses.tools[at(grip.tool)];
    Vec3 way = pose.to_world(grip.place) - position[at(grip.node)];
    Mat3 led = Mat3::Identity();
    if (!grip.push.isZero()) {
        const Vec3 along = pose.orientation * grip.push;
        led = along * along.transpose();
        way = std::max(0.0, along.dot(way)) * along;
    }
    const double wanted = stiffness_ * way.norm();
    const double limit = most(grip);
    if (wanted <= limit) {
        return {stiffness_ * way, wanted > 0.0 || grip.push.isZero() ? Mat3(stiffness_ * led) : Mat3(Mat3::Zero())};
    }
    const Vec3 ahead = way.normalized();
    const Mat3 across = grip.push.isZero() ? Mat3(led - ahead * ahead.transpose()) : Mat3(Mat3::Zero());
    return {limit * ahead, limit / way.norm() * across};
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
        if (grip.push.isZero()) {
            grip.place = pose.to_body(point_[i] + force / stiffness_);  // what pulls harder slips until it does not
        }
    }
}

std::vector<SheetGrip> SheetGrips::kept() const {
    std::vector<SheetGrip> result = grips_;
    std::erase_if(result, [&](const SheetGrip& grip) {
        return grip.push.isZero() && grip.place.norm() > lost_at * world_->tools[at(grip.tool)].reach;
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
