// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the one contact detection. Once per step it finds which surface vertices can meet which partner; both
// resolvers then measure only those, as often as they need.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "flow/contact.hpp"
#include "flow/world.hpp"
#include "physics/contact/contact_point.hpp"
#include "physics/contact/contact_surface.hpp"
#include "physics/contact/friction.hpp"
#include "physics/contact/rigid_partner.hpp"

namespace rhexis {

/// Where the rigid partners are at one moment.
struct PartnerPoses {
    std::vector<Pose> tools;
    std::vector<Pose> bags;

    [[nodiscard]] Pose of(ContactPartner partner, int index) const;
};

/// Poses at share s of a step. The bags are left as they are.
void place_tools(std::span<const ToolState> tools, double s, PartnerPoses& poses);

/// A point that can meet a partner during the step, and what has become of it so far.
struct ContactCandidate {
    ContactPoint at;
    ContactPartner partner = ContactPartner::tool;
    int index = 0;
    ContactSpring spring;  ///< its stiffness only after set_springs
    double carry = 0.0;    ///< share of its last force that the spring bears at a gap of 0, likewise
    Approach approach;
    double hold = 0.0;          ///< pull that it bears before it parts: suction, adhesion [uN]
    double grip = 0.0;          ///< what that adds to the largest friction [uN]
    Vec3 start = Vec3::Zero();  ///< in the partner's frame at the start of the step [mm]
    double start_gap = 0.0;     ///< [mm]

    Vec3 anchor = Vec3::Zero();  ///< in the partner's frame [mm]
    bool touching = false;       ///< at the end of the last substep

    Vec3 force = Vec3::Zero();    ///< of the last substep, on the solid [uN]
    Vec3 impulse = Vec3::Zero();  ///< summed over the step [uN s]
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
    double gap = 0.0;
    bool sliding = false;
};

using ContactCandidates = std::vector<ContactCandidate>;

/// Distance of a point from its partner.
SurfaceDistance measure_gap(const WorldModel& model, const ContactCandidate& candidate, const Pose& pose,
                            const Vec3& point);

/// True if the candidate is certainly apart from its partner, found without measuring.
bool surely_apart(const ContactCandidate& candidate, const Pose& pose, const Vec3& point);

/// All candidates of one solid for one step, ordered by (vertex, partner, index); anchors come from state.memory.
void find_candidates(const WorldModel& model, int solid, const WorldState& state, std::span<const ToolState> tools,
                     double dt, const ContactSurface& surface, ContactCandidates& candidates);

/// The springs that stand for contact in an implicit step of dt [s] of a body of that mass [g].
void set_springs(double dt, double mass, ContactCandidates& candidates);

/// Cortex that slid on the capsule has come off it for good.
void break_adhesion(const ContactCandidates& candidates, std::vector<BagState>& bags);

/// The contacts that carried force in the step.
void report_contacts(const ContactCandidates& candidates, int solid, double dt, ContactSet& contacts);

/// What the next step must remember: the anchors of contacts that touch now.
void remember_contacts(const ContactCandidates& candidates, int solid, std::vector<ContactMemory>& memory);

}  // namespace rhexis
