// SPDX-License-Identifier: GPL-3.0-or-later
// What forceps hold of a shell.
#include <algorithm>

#include "base/index.hpp"
#include "physics/shell/shell_contact.hpp"

namespace rhexis {
namespace {

constexpr double lost_at = 2.0;  // times the reach of jaws from their middle: it has slipped out

}  // namespace

bool ShellContacts::holds(int tool) const {
    return std::any_of(list_.begin(), list_.end(),
                       [tool](const Contact& contact) { return is_held(contact) && contact.touch.index == tool; });
}

/// Samples that jaws close on in this step, or have held since an earlier one.
std::vector<std::size_t> ShellContacts::between_jaws(int tool, const ShellSamples& on) const {
    std::vector<std::size_t> samples;
    if (partners_.tool_states[at(tool)].previous_jaw > closed_jaw && partners_.from == 0.0) {
        const Vec3 middle = pose_of(ContactPartner::jaws, tool, 0.0).position;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if ((points_[i] - middle).norm() < partners_.tools[at(tool)].lens_reach) {
                samples.push_back(i);
            }
        }
        return samples;
    }
    for (const ShellTouch& touch : state_->touches) {
        if (touch.partner == ContactPartner::jaws && touch.index == tool && at(touch.sample) < on.samples.size()) {
            samples.push_back(at(touch.sample));
        }
    }
    return samples;
}

void ShellContacts::take(int tool, const ShellSamples& on, std::size_t sample) {
    Contact contact;
    contact.on = &on;
    contact.touch.partner = ContactPartner::jaws;
    contact.touch.index = tool;
    contact.touch.sample = static_cast<int>(sample);
    contact.stiffness = settings_.stiffer * modulus_ / on.samples[sample].place.thickness * on.samples[sample].area;
    contact.anchor = partner_pose(contact, 0.0).to_body(points_[sample]);
    contact.gap = HUGE_VAL;
    add(std::move(contact));
}

void ShellContacts::meet_jaws() {
    for (int i = 0; i < static_cast<int>(partners_.tools.size()); ++i) {
        const ToolState& state = partners_.tool_states[at(i)];
        if (partners_.tools[at(i)].kind != ToolKind::forceps || !state.present || state.jaw > closed_jaw) {
            continue;
        }
        const ShellSamples& on = samples_at(level_of_layers);
        find_points(on);
        const std::vector<std::size_t> held = between_jaws(i, on);
        for (const std::size_t sample : held) {
            take(i, on, sample);
            list_.back().most = partners_.tools[at(i)].hold / static_cast<double>(held.size());
        }
    }
}

/// By jaws.
SpringResponse ShellContacts::lead(const Contact& contact, const Meeting& now) const {
    const Vec3 way = offset(contact, now.point);
    const double length = way.norm();
    SpringResponse led;
    led.stretch = std::min(length, contact.most / contact.stiffness);
    led.sliding = led.stretch < length;
    led.force = -contact.stiffness * way;
    led.stiffness = contact.stiffness * Mat3::Identity();
    if (led.sliding) {
        const Vec3 ahead = way / length;
        led.force = -contact.most * ahead;
        led.stiffness = contact.most / length * (Mat3::Identity() - ahead * ahead.transpose());
    }
    return led;
}

/// place: in the frame of the jaws.
bool ShellContacts::still_holds(const Contact& contact, const Vec3& place) const {
    return place.norm() < lost_at * partners_.tools[at(contact.touch.index)].lens_reach;
}

}  // namespace rhexis
