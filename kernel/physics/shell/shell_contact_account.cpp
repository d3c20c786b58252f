// SPDX-License-Identifier: GPL-3.0-or-later
// Where the energy of contacts goes in a step, for tests and measurements. Of a spring whose force at the end is f,
// backward Euler takes what f along its whole way is more than what it gained: of the normal one f_n (depth - depth_0)
// less the gain, of friction's half its stiffness times the square of the way of its stretch. Both are squares. What
// the step along straight lines and turned normals add to that is of third order and of either sign. Of layers
// that part it takes what was stored when the step began.
#include "base/index.hpp"
#include "physics/shell/shell_contact.hpp"

namespace rhexis {

void ShellContacts::account_start() {
    pose_.set(state_->rotation, start_);
    at_start_.clear();
    double found = 0.0;
    for (const Contact& contact : list_) {
        const Meeting then = meeting(contact, 0.0);
        Before& before = at_start_.emplace_back();
        before.gap = then.gap;
        before.stretch = offset(contact, then.point, 0.0);
        before.energy = energy_of(contact, then, 0.0);
        if (!is_held(contact)) {
            before.energy += 0.5 * sticking(contact) * before.stretch.squaredNorm();
        }
        found += before.energy;
    }
    work_.found = found;
}

/// way: of the partner where it touches.
void ShellContacts::account_end(std::size_t index, const std::vector<Vec3>& points, const Meeting& now,
                                const SpringResponse& pushed, const Vec3& stretch, const Vec3& way) {
    const Contact& contact = list_[index];
    const Before& before = at_start_[index];
    ContactTerm term;
    fill(contact, now, pushed, term);
    Vec3 slid = -way;
    for (const ContactShare& share : term.more) {
        slid += share.share * (points[at(share.node)] - start_[at(share.node)]);
    }
    if (is_held(contact)) {
        const double stiff = sticking(contact);
        const double slip = offset(contact, now.point).norm() - stretch.norm();
        work_.lost -= pushed.force.dot(slid) + 0.5 * stiff * stretch.squaredNorm() - before.energy +
                      stiff * stretch.norm() * slip;
        return;
    }
    Meeting then = now;
    then.gap = before.gap;
    const double deeper = before.gap - now.gap;
    const double normal = pushed.normal_force;
    const Vec3 offset_now = offset(contact, now.point);
    const Vec3 across = offset_now - now.normal.dot(offset_now) * now.normal;
    const double stiff = sticking(contact);
    work_.lost += normal * deeper - (energy_of(contact, now) - energy_of(contact, then)) +
                  0.5 * stiff * (stretch - before.stretch).squaredNorm();
    work_.lost += stiff * stretch.dot(slid - (across - before.stretch)) - normal * (now.normal.dot(slid) + deeper);
}

}  // namespace rhexis
