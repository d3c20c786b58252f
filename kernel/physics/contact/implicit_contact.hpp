// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: contact as stiff springs inside the Newton iterations of an implicit step. What a spring bore at the
// end of a step, less a small share, it bears in the next one without giving way (the update of an augmented Lagrangian
// [SimoLaursen1992], once per step): springs soft enough for Newton's iterations are at rest as good as stiff ones.
#pragma once

#include "physics/contact/contact_candidates.hpp"
#include "physics/solve/contact_term.hpp"

namespace rhexis {

/// Begins a substep: what each contact bears without giving way, of what it bore in the last.
void carry_over(ContactCandidates& candidates);

/// Forces and stiffness of all contacts at an iterate, appended to `terms`. positions: coarse nodes; poses: at the end
/// of the substep.
void contact_terms(const WorldModel& model, const ContactCandidates& candidates, const std::vector<Vec3>& positions,
                   const PartnerPoses& poses, bool edge_slides, std::vector<ContactTerm>& terms);

/// Ends a substep of dt [s]: sums impulses and moves the anchors of what slid or is apart.
void settle_contacts(const WorldModel& model, const std::vector<Vec3>& positions, const PartnerPoses& poses, double dt,
                     ContactCandidates& candidates);

}  // namespace rhexis
