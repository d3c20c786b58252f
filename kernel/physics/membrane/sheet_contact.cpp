// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane/sheet_contact.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "mesh/nearest_place.hpp"
#include "physics/contact/rigid_partner.hpp"
#include "physics/contact/tool_shape.hpp"
#include "physics/membrane/needle.hpp"

namespace rhexis {
namespace {

constexpr double stiffer = 5.0;  // a contact than the sheet's modulus times thickness
constexpr double softer_forceps = 0.3;
constexpr double margin = 0.4;  // beyond what moves in a step, within which something may touch [mm]

Vec3 point_of(const SheetContact& contact, const std::vector<Vec3>& position) {
    Vec3 point = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        if (contact.nodes[k] >= 0) {
            point += contact.weights[k] * position[at(contact.nodes[k])];
        }
    }
    return point;
}

double friction_of(const WorldModel& world, const MembraneModel& model, const SheetTouch& touch) {
    if (touch.partner == ContactPartner::support) {
        return model.support ? model.support->friction : 0.0;
    }
    return friction_of(rigid_partners(world), touch.partner, touch.index);
}

/// Of the stiffness of a contact: forceps are about a flap that is slack, which springs as stiff as those of a needle
/// toss about.
double stiffness_share(const WorldModel& world, const SheetTouch& touch) {
    const bool forceps =
        touch.partner == ContactPartner::tool && world.tools[at(touch.index)].kind == ToolKind::forceps;
    return forceps ? softer_forceps : 1.0;
}

/// What contacts are found by, in ascending order; last those of the sheet with itself.
std::array<int, 3> rank(const SheetTouch& touch) {
    const bool own = touch.triangle >= 0 && touch.node >= 0;
    const int partner = touch.partner == ContactPartner::support ? 0 : touch.partner == ContactPartner::plane ? 1 : 2;
    return {own ? 3 : partner, touch.index, std::max(touch.node, touch.triangle)};
}

/// Whether a triangle is farther than the margin from a part of an instrument, by the ball about it.
bool surely_apart(const RoundedCone& cone, const Pose& pose, const std::array<Vec3, 3>& x) {
    const Vec3 middle = (x[0] + x[1] + x[2]) / 3.0;
    const double size = std::sqrt(
        std::max({(x[0] - middle).squaredNorm(), (x[1] - middle).squaredNorm(), (x[2] - middle).squaredNorm()}));
    const Vec3 a = pose.to_world(cone.a);
    const Vec3 along = pose.to_world(cone.b) - a;
    const double square = along.squaredNorm();
    const double share = square > 0.0 ? std::clamp(along.dot(middle - a) / square, 0.0, 1.0) : 0.0;
    const double reach = std::max(cone.radius_a, cone.radius_b) + margin + size;
    return (a + share * along - middle).squaredNorm() > reach * reach;
}

/// The tangent of a part of an instrument where it is nearest to a point in its frame.
void touch_plane(const RoundedCone& cone, const Vec3& point, SheetContact& contact) {
    const SurfaceDistance near = cone_distance(cone, point);
    contact.out = near.normal;
    contact.foot = point - near.distance * near.normal;
}

/// Whether a needle that goes on along its axis meets a place with its end.
bool under_point(const ToolModel& model, const Pose& pose, const Vec3& place) {
    const Vec3 own = pose.to_body(place);
    return own.head<2>().norm() < model.parts[0].radius_a &&
           own.z() < deepest_dent;  // deeper, it lies beside the needle
}

/// Whether the jaws of an instrument hold a corner: then they lie on both sides of the triangle, and meeting it would
/// push out what they hold.
bool between_jaws(const MembraneState& state, const std::array<int, 3>& triangle, int tool) {
    return std::any_of(state.grips.begin(), state.grips.end(), [&](const SheetGrip& grip) {
        return grip.tool == tool && !grip.pushed &&
               std::find(triangle.begin(), triangle.end(), grip.node) != triangle.end();
    });
}

/// Whether the sheet ends or is torn at a triangle: a needle that is through it touches what is left with its side.
bool at_tear(const MembraneSheet& sheet, int triangle) {
    const TriNeighbours& near = sheet.neighbours;
    for (const int node : sheet.mesh.triangles[at(triangle)]) {
        for (int i = near.offset[at(node)]; i < near.offset[at(node) + 1]; ++i) {
            const std::array<int, 3>& across = near.across[at(near.triangles[at(i)])];
            if (std::find(across.begin(), across.end(), -1) != across.end()) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

void SheetContacts::add(SheetContact contact, const MembraneState& state, const Pose& start) {
    const std::vector<SheetTouch>& known = state.touches;
    const std::array<int, 3> own = rank(contact.touch);
    while (next_known_ < known.size() && rank(known[next_known_]) < own) {
        ++next_known_;
    }
    const bool again = next_known_ < known.size() && rank(known[next_known_]) == own;
    contact.touch.stretch = again ? known[next_known_].stretch : Vec3(Vec3::Zero());
    contact.anchor = start.to_body(point_of(contact, state.position)) - contact.touch.stretch;
    list_.push_back(contact);
}

void SheetContacts::meet_support(const MembraneState& state, double dt) {
    const MembraneModel& model = world_->membranes[at(membrane_)];
    for (int node = 0; model.support && node < static_cast<int>(state.position.size()); ++node) {
        if (is_out(*state.sheet, node)) {
            continue;
        }
        const double reach = margin + dt * state.velocity[at(node)].norm();
        const SurfaceDistance near = bag_distance(model.support->shape, support_.to_body(state.position[at(node)]));
        if (near.distance < reach) {
            SheetContact contact;
            contact.out = near.normal;
            contact.foot = support_.to_body(state.position[at(node)]) - near.distance * near.normal;
            contact.touch.node = contact.nodes[0] = node;
            contact.touch.partner = ContactPartner::support;
            add(contact, state, support_);
        }
    }
}

double SheetContacts::impulse_on_support() const {
    double sum = 0.0;
    for (const SheetContact& contact : list_) {
        sum -= contact.touch.partner == ContactPartner::support ? contact.impulse.z() : 0.0;
    }
    return sum;
}

void SheetContacts::meet_planes(const MembraneState& state, double dt) {
    for (int i = 0; i < static_cast<int>(world_->planes.size()); ++i) {
        const PlaneModel& plane = world_->planes[at(i)];
        for (int node = 0; node < static_cast<int>(state.position.size()); ++node) {
            const double reach = margin + dt * state.velocity[at(node)].norm();
            if (!is_out(*state.sheet, node) && plane.normal.dot(state.position[at(node)] - plane.point) < reach) {
                SheetContact contact;
                contact.touch.node = contact.nodes[0] = node;
                contact.touch.partner = ContactPartner::plane;
                contact.touch.index = i;
                contact.foot = plane.point;
                contact.out = plane.normal;
                add(contact, state, Pose{});
            }
        }
    }
}

void SheetContacts::meet_tool(const MembraneState& state, const ToolState& tool, int index) {
    const ToolModel& model = world_->tools[at(index)];
    Box box = swept_box(model, tool);
    box.low -= Vec3::Constant(margin);
    box.high += Vec3::Constant(margin);
    const bool in_tear = lip_of(model, tool, state).has_value();  // then its end is hooked, or free
    std::vector<Vec3> met;                                        // points that neighbours share count once
    for (int t = 0; t < static_cast<int>(state.sheet->mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = state.sheet->mesh.triangles[at(t)];
        const std::array<Vec3, 3> x{state.position[at(n[0])], state.position[at(n[1])], state.position[at(n[2])]};
        const Vec3 low = x[0].cwiseMin(x[1]).cwiseMin(x[2]);
        const Vec3 high = x[0].cwiseMax(x[1]).cwiseMax(x[2]);
        if ((low.array() > box.high.array()).any() || (high.array() < box.low.array()).any() ||
            between_jaws(state, n, index)) {
            continue;
        }
        SheetContact best;
        double least = HUGE_VAL;
        const RoundedCone* nearest = nullptr;
        for (int part = in_tear ? 1 : 0; part < static_cast<int>(model.parts.size()); ++part) {
            const RoundedCone& cone = model.parts[at(part)];
            if (surely_apart(cone, tool.pose, x)) {
                continue;
            }
            const std::array<double, 3> weights =
                nearest_to_segment(x, tool.pose.to_world(cone.a), tool.pose.to_world(cone.b));
            const double gap = cone_distance(cone, tool.pose.to_body(place_in(x, weights))).distance;
            if (gap < least) {
                least = gap;
                nearest = &cone;
                best.weights = weights;
            }
        }
        if (!(least < margin)) {
            continue;
        }
        const Vec3 point = place_in(x, best.weights);
        touch_plane(*nearest, tool.previous_pose.to_body(point), best);
        if (model.kind == ToolKind::cystotome && under_point(model, tool.previous_pose, point) &&
            !at_tear(*state.sheet, t)) {
            // a needle's end presses along the needle, however far it dents the sheet
            best.foot.setZero();
            best.out = -Vec3::UnitZ();
        }
        const bool again =
            std::any_of(met.begin(), met.end(), [&](const Vec3& other) { return (other - point).norm() < 1e-9; });
        if (!again) {
            met.push_back(point);
            best.nodes = n;
            best.touch.triangle = t;
            best.touch.index = index;
            add(best, state, tool.previous_pose);
        }
    }
}

void SheetContacts::look(const WorldModel& world, int membrane, const MembraneState& state,
                         std::span<const ToolState> tools, double dt) {
    world_ = &world;
    membrane_ = membrane;
    const MembraneModel& model = world.membranes[at(membrane)];
    stiffness_ = stretch_stiffness(model, *state.sheet, stiffer);
    support_.position = state.support.lift * Vec3::UnitZ();
    list_.clear();
    next_known_ = 0;
    meet_support(state, dt);
    meet_planes(state, dt);
    for (int i = 0; i < static_cast<int>(tools.size()); ++i) {
        if (tools[at(i)].present) {
            meet_tool(state, tools[at(i)], i);
        }
    }
}

Pose SheetContacts::pose_of(const SheetContact& contact, const PartnerPoses& poses) const {
    switch (contact.touch.partner) {
        case ContactPartner::tool:
            return poses.tools[at(contact.touch.index)];
        case ContactPartner::support:
            return support_;
        default:
            return {};
    }
}

void SheetContacts::place(const PartnerPoses& poses) {
    const MembraneModel& model = world_->membranes[at(membrane_)];
    for (SheetContact& contact : list_) {
        const Pose pose = pose_of(contact, poses);
        contact.normal = pose.orientation * contact.out;
        contact.level = contact.normal.dot(pose.to_world(contact.foot));
        contact.held_at = pose.to_world(contact.anchor);
        contact.spring = {stiffness_ * stiffness_share(*world_, contact.touch),
                          friction_of(*world_, model, contact.touch)};
    }
}

void SheetContacts::terms(const std::vector<Vec3>& position, std::vector<ContactTerm>& terms) const {
    for (const SheetContact& contact : list_) {
        const Vec3 point = point_of(contact, position);
        const double gap = contact.normal.dot(point) - contact.level;
        if (gap < 0.0) {
            const SpringResponse pushed =
                spring_contact(contact.spring, gap, contact.normal, point - contact.held_at, true);
            ContactTerm& term = terms.emplace_back();
            term.nodes = contact.nodes;
            term.weights = contact.weights;
            term.force = pushed.force;
            term.stiffness = pushed.stiffness;
        }
    }
}

void SheetContacts::settle(const std::vector<Vec3>& position, const PartnerPoses& poses, double dt) {
    for (SheetContact& contact : list_) {
        contact.point = point_of(contact, position);
        contact.gap = contact.normal.dot(contact.point) - contact.level;
        contact.sliding = false;
        const Vec3 here = pose_of(contact, poses).to_body(contact.point);
        Vec3 stretch = Vec3::Zero();
        if (contact.gap < 0.0) {
            const SpringResponse pushed =
                spring_contact(contact.spring, contact.gap, contact.normal, contact.point - contact.held_at, true);
            contact.sliding = pushed.sliding;
            contact.impulse += dt * pushed.force;
            const Vec3 offset = here - contact.anchor;
            const Vec3 tangential = offset - contact.out.dot(offset) * contact.out;
            const double size = tangential.norm();
            stretch = size > 0.0 ? Vec3(std::min(1.0, pushed.stretch / size) * tangential) : Vec3(Vec3::Zero());
        }
        contact.anchor = here - stretch;
        contact.touch.stretch = stretch;
    }
}

void SheetContacts::report(double dt, ContactSet& contacts) const {
    for (const SheetContact& contact : list_) {
        if (contact.impulse.isZero()) {
            continue;
        }
        Contact& result = contacts.emplace_back();
        result.solid = -1;
        result.membrane = membrane_;
        result.nodes = contact.nodes;
        result.weights = contact.weights;
        result.partner = contact.touch.partner;
        result.partner_index = contact.touch.index;
        result.point = contact.point;
        result.normal = contact.normal;
        result.gap = contact.gap;
        result.force = contact.impulse / dt;
        result.sliding = contact.sliding;
    }
}

std::vector<SheetTouch> SheetContacts::touches() const {
    std::vector<SheetTouch> result;
    for (const SheetContact& contact : list_) {
        if (contact.gap < 0.0 && !contact.impulse.isZero()) {
            result.push_back(contact.touch);
        }
    }
    return result;
}

}  // namespace rhexis
