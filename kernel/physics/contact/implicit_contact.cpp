// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/implicit_contact.hpp"

#include <algorithm>

namespace rhexis {

namespace {

struct Touch {
    SurfaceDistance gap = nothing_near();
    SpringResponse response;
};

/// No force if apart.
Touch touch(const WorldModel& model, const ContactCandidate& candidate, const Pose& pose, const Vec3& point,
            bool edge_slides) {
    Touch found;
    if (candidate.spring.carried == 0.0 && surely_apart(candidate, pose, point)) {
        return found;
    }
    found.gap = measure_gap(model, candidate, pose, point);
    if (candidate.spring.normal_force(found.gap.distance) > 0.0) {
        found.response = spring_contact(candidate.spring, found.gap.distance, found.gap.normal,
                                        point - pose.to_world(candidate.anchor), edge_slides);
    }
    return found;
}

/// Leaves as much of the offset as friction can hold.
void move_anchor(const Touch& now, const Pose& pose, const Vec3& point, ContactCandidate& candidate) {
    if (!candidate.touching) {
        candidate.anchor = pose.to_body(point);
    } else if (now.response.sliding) {
        const Vec3 offset = point - pose.to_world(candidate.anchor);
        const Vec3 tangential = offset - now.gap.normal.dot(offset) * now.gap.normal;
        candidate.anchor = pose.to_body(point - project_on_disc(tangential, now.response.stretch));
    }
}

}  // namespace

void carry_over(ContactCandidates& candidates) {
    for (ContactCandidate& candidate : candidates) {
        candidate.spring.carried =
            candidate.touching ? candidate.carry * std::max(0.0, candidate.force.dot(candidate.normal)) : 0.0;
    }
}

void contact_terms(const WorldModel& model, const ContactCandidates& candidates, const std::vector<Vec3>& positions,
                   const PartnerPoses& poses, bool edge_slides, std::vector<ContactTerm>& terms) {
    for (const ContactCandidate& candidate : candidates) {
        const Vec3 point = point_of(candidate.at, positions);
        const Pose pose = poses.of(candidate.partner, candidate.index);
        const Touch now = touch(model, candidate, pose, point, edge_slides);
        if (now.response.normal_force == 0.0) {
            continue;
        }
        ContactTerm term;
        bearing_nodes(candidate.at, term.nodes, term.weights);
        if (candidate.at.weights[3] > 0.0) {
            term.more.push_back({candidate.at.nodes[3], candidate.at.weights[3] * Mat3::Identity()});
        }
        if (candidate.partner == ContactPartner::bag) {
            term.body = candidate.index;
            term.arm = point - pose.position;
        }
        term.force = now.response.force;
        term.stiffness = now.response.stiffness;
        terms.push_back(term);
    }
}

void settle_contacts(const WorldModel& model, const std::vector<Vec3>& positions, const PartnerPoses& poses, double dt,
                     ContactCandidates& candidates) {
    for (ContactCandidate& candidate : candidates) {
        const Vec3 point = point_of(candidate.at, positions);
        const Pose pose = poses.of(candidate.partner, candidate.index);
        const Touch now = touch(model, candidate, pose, point, true);
        candidate.touching = now.response.normal_force > 0.0;
        candidate.force = now.response.force;
        move_anchor(now, pose, point, candidate);
        if (candidate.touching) {
            candidate.impulse += dt * now.response.force;
            candidate.point = point;
            candidate.normal = now.gap.normal;
            candidate.gap = now.gap.distance;
            candidate.sliding = now.response.sliding;
        }
    }
}

}  // namespace rhexis
