// SPDX-License-Identifier: GPL-3.0-or-later
// What of a shell's contacts is too far apart in a step to be looked at again.
#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "physics/shell/shell_contact.hpp"

namespace rhexis {
namespace {

constexpr double told_apart = 1e-9;  // more than that of a gap [mm]

}  // namespace

/// Neither pushed nor held.
bool ShellContacts::is_apart(const Contact& contact, double gap) const {
    return !is_held(contact) && !(gap < (contact.stuck > 0.0 ? tack_.range : 0.0));
}

bool ShellContacts::went_too_far(const std::vector<Vec3>& from, const std::vector<Vec3>& to) const {
    Vec3 mean = Vec3::Zero();
    for (std::size_t n = 0; n < ways_.size(); ++n) {
        mean += (to[n] - from[n]) / static_cast<double>(ways_.size());
    }
    for (std::size_t n = 0; n < ways_.size(); ++n) {
        if (!((to[n] - from[n] - mean).norm() <= ways_[n])) {
            return true;
        }
    }
    return false;
}

void ShellContacts::set_iterate(const std::vector<Vec3>& points) {
    now_ = &points;
    pose_.set(state_->rotation, points);
    const std::size_t shell = 2 * state_->position.size();
    double moved = 0.0;
    double turned = 0.0;
    for (std::size_t i = 0; i < first_.size(); ++i) {
        double& most = i < shell && i % 2 == 1 ? turned : moved;
        most = std::max(most, (points[i] - first_[i]).squaredNorm());
    }
    moved_ = std::sqrt(moved);
    turned_ = std::sqrt(turned);
}

/// A turn's numbers change by no less than the angle.
ShellContacts::Known ShellContacts::known_of(const Contact& contact, double gap) const {
    Known known{gap, 0.0, contact.lever.norm() + contact.foot_lever.norm()};
    for (const ShellPlace* own : {&place(contact), &contact.foot}) {
        for (std::size_t k = 0; k < 3; ++k) {
            known.by_move += std::abs(own->weights[k]);
            known.by_turn += own->arms[k].norm();
        }
    }
    return known;
}

/// Where it is at the iterate, if it pushes or holds there. What was far from that at the first iterate is not looked
/// at again.
std::optional<ShellContacts::Meeting> ShellContacts::touching(const Contact& contact) const {
    const Known& known = contact.known;
    if (is_flat(contact) &&
        is_apart(contact, known.gap - known.by_move * moved_ - known.by_turn * turned_ - told_apart)) {
        return std::nullopt;
    }
    const Meeting now = meeting(contact);
    return is_apart(contact, now.gap) ? std::nullopt : std::optional(now);
}

}  // namespace rhexis
