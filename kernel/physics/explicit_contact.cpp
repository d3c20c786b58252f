// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/explicit_contact.hpp"

#include <algorithm>

namespace rhexis {

namespace {

constexpr int sweeps = 4;
constexpr double fastest_ejection = 20.0;  ///< at which penetration is undone, so that it throws nothing [mm/s]
constexpr double anchor_pull = 0.2;        ///< share of the drift from the anchor undone in a substep
constexpr double presliding = 1e-4;        ///< of the size of a tetrahedron: a contact keeps its anchor within this

Vec3 place(const SurfaceVertex& vertex, const ExplicitSolid& solid) {
    const Vec3 first = solid.position(vertex.nodes[0]);
    return vertex.nodes[1] < 0 ? first : Vec3(0.5 * (first + solid.position(vertex.nodes[1])));
}

Vec3 pace(const SurfaceVertex& vertex, const ExplicitSolid& solid) {
    const Vec3 first = solid.velocity(vertex.nodes[0]);
    return vertex.nodes[1] < 0 ? first : Vec3(0.5 * (first + solid.velocity(vertex.nodes[1])));
}

/// New contacts anchor where they are; those that slid drag their anchor behind by no more than the slack. A contact
/// that opens by less than the slack keeps its anchor: a resting body trembles within it and must not creep.
void move_anchor(const Pose& pose, const Vec3& point, const Vec3& normal, bool sliding, bool near, double slack,
                 ContactCandidate& candidate) {
    if (near && !candidate.touching) {
        candidate.anchor = pose.to_body(point);
    } else if (near && sliding) {
        const Vec3 offset = point - pose.to_world(candidate.anchor);
        candidate.anchor = pose.to_body(point - project_on_disc(offset - normal.dot(offset) * normal, slack));
    }
    candidate.touching = near;
}

}  // namespace

void ExplicitContact::begin(const WorldModel& model, const ContactSurface& surface, ContactCandidates& candidates,
                            const ExplicitSolid& solid) {
    model_ = &model;
    surface_ = &surface;
    candidates_ = &candidates;
    mass_.clear();
    int last = -1;
    for (const ContactCandidate& candidate : candidates) {
        for (int node : surface.vertices()[candidate.vertex].nodes) {
            mass_.push_back(node < 0 ? 0.0 : solid.mass(node));
            last = std::max(last, node);
        }
    }
    local_of_.assign(static_cast<std::size_t>(last + 1), -1);
}

int ExplicitContact::local_node(int node, const ExplicitSolid& solid) {
    if (node < 0) {
        return -1;
    }
    if (local_of_[node] < 0) {
        local_of_[node] = static_cast<int>(nodes_.size());
        nodes_.push_back(node);
        velocity_.push_back(solid.velocity(node));
    }
    return local_of_[node];
}

void ExplicitContact::set_masses(Active& active) const {
    double response = active.weight * (active.share[0] + active.share[1]);
    double turning = 0.0;
    double all_turning = 0.0;
    if (active.bag >= 0) {
        const BagInertia& bag = bag_response_[active.bag];
        response += 1.0 / bag.mass;
        turning = active.arm.cross(active.normal).squaredNorm() / bag.turning;
        all_turning = active.arm.squaredNorm() / bag.turning;
    }
    active.normal_mass = response > 0.0 ? 1.0 / (response + turning) : 0.0;
    active.tangent_mass = response > 0.0 ? 1.0 / (response + all_turning) : 0.0;
}

void ExplicitContact::collect(double dt, const PartnerPoses& before, const PartnerPoses& after,
                              const ExplicitSolid& solid) {
    active_.clear();
    nodes_.clear();
    velocity_.clear();
    for (std::size_t c = 0; c < candidates_->size(); ++c) {
        ContactCandidate& candidate = (*candidates_)[c];
        const SurfaceVertex& vertex = surface_->vertices()[candidate.vertex];
        const Vec3 point = place(vertex, solid);
        const Pose pose = after.of(candidate.partner, candidate.index);
        if (surely_apart(candidate, pose, point)) {
            candidate.touching = false;
            continue;
        }
        const Gap gap = measure_gap(*model_, candidate.partner, candidate.index, pose, point);
        // Anything that could close within this substep, whatever the others do to it
        if (!(gap.gap < 2.0 * dt * (pace(vertex, solid).norm() + fastest_ejection))) {
            candidate.touching = false;
            continue;
        }
        Active active;
        active.candidate = static_cast<int>(c);
        for (std::size_t k = 0; k < 2; ++k) {
            active.nodes[k] = local_node(vertex.nodes[k], solid);
            const double mass = mass_[2 * c + k];
            active.share[k] = mass > 0.0 ? vertex.weight / mass : 0.0;
        }
        active.weight = vertex.weight;
        active.normal = gap.normal;
        const Pose old_pose = before.of(candidate.partner, candidate.index);
        const Vec3 carried = pose.to_world(old_pose.to_body(point)) - point;  // where a point of the partner goes
        const double advance = gap.normal.dot(carried);
        active.normal_target = (advance + std::min(-gap.gap - advance, dt * fastest_ejection)) / dt;
        Vec3 wanted = carried / dt;
        if (candidate.touching) {
            const Vec3 old_anchor = old_pose.to_world(candidate.anchor);
            wanted = (pose.to_world(candidate.anchor) - old_anchor + anchor_pull * (old_anchor - point)) / dt;
        }
        active.tangent_target = wanted - active.normal.dot(wanted) * active.normal;
        if (candidate.partner == ContactPartner::bag) {
            active.bag = candidate.index;
            active.arm = point - pose.position;
        }
        set_masses(active);
        if (candidate.touching) {
            const double push = std::max(0.0, candidate.force.dot(active.normal));
            active.normal_impulse = dt * push;
            const Vec3 rest = candidate.force - candidate.force.dot(active.normal) * active.normal;
            active.tangent_impulse = dt * project_on_disc(rest, candidate.spring.friction * push);
        }
        active_.push_back(active);
    }
}

Vec3 ExplicitContact::relative_velocity(const Active& active, const std::vector<BagState>& bags) const {
    Vec3 velocity = velocity_[active.nodes[0]];
    if (active.nodes[1] >= 0) {
        velocity = 0.5 * (velocity + velocity_[active.nodes[1]]);
    }
    if (active.bag >= 0) {
        velocity -= bags[active.bag].velocity + bags[active.bag].angular_velocity.cross(active.arm);
    }
    return velocity;
}

void ExplicitContact::apply(const Active& active, const Vec3& impulse, std::vector<BagState>& bags) {
    for (std::size_t k = 0; k < 2; ++k) {
        if (active.nodes[k] >= 0) {
            velocity_[active.nodes[k]] += active.share[k] * impulse;
        }
    }
    if (active.bag >= 0) {
        const BagInertia& bag = bag_response_[active.bag];
        bags[active.bag].velocity -= impulse / bag.mass;
        bags[active.bag].angular_velocity -= active.arm.cross(impulse) / bag.turning;
    }
}

void ExplicitContact::sweep(std::vector<BagState>& bags) {
    for (Active& active : active_) {
        const double friction = (*candidates_)[active.candidate].spring.friction;
        const Vec3 velocity = relative_velocity(active, bags);
        const double along = active.normal.dot(velocity);
        const double normal_impulse =
            std::max(0.0, active.normal_impulse + active.normal_mass * (active.normal_target - along));
        const Vec3 across = velocity - along * active.normal;
        const Vec3 sticking = active.tangent_impulse + active.tangent_mass * (active.tangent_target - across);
        const Vec3 tangent_impulse = project_on_disc(sticking, friction * normal_impulse);
        active.sliding = sticking.squaredNorm() > tangent_impulse.squaredNorm();
        apply(active,
              (normal_impulse - active.normal_impulse) * active.normal + (tangent_impulse - active.tangent_impulse),
              bags);
        active.normal_impulse = normal_impulse;
        active.tangent_impulse = tangent_impulse;
    }
}

void ExplicitContact::finish(double dt, const PartnerPoses& after, ExplicitSolid& solid,
                             const std::vector<BagState>& bags) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        solid.set_velocity(nodes_[i], velocity_[i]);
        local_of_[nodes_[i]] = -1;
    }
    for (const Active& active : active_) {
        ContactCandidate& candidate = (*candidates_)[active.candidate];
        const Vec3 impulse = active.normal_impulse * active.normal + active.tangent_impulse;
        candidate.force = impulse / dt;
        candidate.impulse += impulse;
        const SurfaceVertex& vertex = surface_->vertices()[candidate.vertex];
        const Vec3 velocity = relative_velocity(active, bags);
        const Vec3 point = place(vertex, solid) + dt * velocity;
        const double slack = presliding * vertex.size;
        const double gap = dt * (active.normal.dot(velocity) - active.normal_target);
        move_anchor(after.of(candidate.partner, candidate.index), point, active.normal, active.sliding, gap < slack,
                    slack, candidate);
        if (active.normal_impulse > 0.0) {
            candidate.point = point;
            candidate.normal = active.normal;
            candidate.gap = std::min(0.0, gap);
            candidate.sliding = active.sliding;
        }
    }
}

void ExplicitContact::resolve(double dt, const PartnerPoses& before, const PartnerPoses& after, ExplicitSolid& solid,
                              std::vector<BagState>& bags) {
    bag_response_.clear();
    for (const BagModel& bag : model_->bags) {
        bag_response_.push_back(bag_response(bag, dt));
    }
    collect(dt, before, after, solid);
    if (active_.empty()) {
        return;
    }
    for (const Active& active : active_) {
        apply(active, active.normal_impulse * active.normal + active.tangent_impulse, bags);
    }
    for (int i = 0; i < sweeps; ++i) {
        sweep(bags);
    }
    finish(dt, after, solid, bags);
}

}  // namespace rhexis
