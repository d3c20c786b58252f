// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_tools.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "physics/shell/plunger.hpp"

namespace rhexis {
namespace {

constexpr int most_tries = 3;             // of a step with ever shorter ways of plungers, before they hold still
constexpr double far_from_balance = 0.1;  // residual at which a force is none
constexpr double hard = 0.1;              // of the most force: a plunger that pressed so hard is why
constexpr double careful = 4.0;           // so much shorter is its next way

/// Before it is pushed, in the injector's frame.
RoundedCone plunger(const Cartridge& cartridge) {
    const auto along = [&](double z) { return cartridge.bore.pose.to_world(Vec3(0.0, 0.0, z)); };
    const double end = cartridge.plunger_from - cartridge.plunger_radius;
    return {along(end), along(end - cartridge.stroke), cartridge.plunger_radius, cartridge.plunger_radius};
}

/// Along the bore of an injector in this pose, to its tip.
Vec3 direction(const Cartridge& cartridge, const Pose& pose) {
    return pose.orientation * (cartridge.bore.pose.orientation * Vec3::UnitZ());
}

}  // namespace

ShellTools::ShellTools(std::span<const ToolModel> tools) : tools_(tools.begin(), tools.end()) {
    for (ToolModel& tool : tools_) {
        cartridges_.push_back(tool.cartridge.value_or(Cartridge{}));
        if (tool.cartridge) {
            tool.parts = {plunger(*tool.cartridge)};
        }
    }
}

bool ShellTools::pushes(std::size_t tool) const {
    return tools_[tool].kind == ToolKind::injector && given_[tool].present;
}

void ShellTools::place(std::span<const ToolState> states, std::span<const PlungerState> plungers, double dt) {
    RHEXIS_ASSERT(states.size() == tools_.size() && plungers.size() == tools_.size());
    given_.assign(states.begin(), states.end());
    before_.assign(plungers.begin(), plungers.end());
    after_ = before_;
    goal_.assign(tools_.size(), 0.0);
    tried_.assign(tools_.size(), 0.0);
    tries_ = 0;
    tubes_.clear();
    tube_states_.clear();
    tube_tools_.clear();
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        if (pushes(i)) {
            tubes_.push_back(cartridges_[i].bore);
            tube_states_.push_back(given_[i]);
            tube_tools_.push_back(static_cast<int>(i));
            goal_[i] = plunger_goal(cartridges_[i], before_[i], given_[i].jaw * cartridges_[i].stroke, dt);
        }
    }
    move_plungers();
}

void ShellTools::move_plungers() {
    states_ = given_;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        if (pushes(i)) {
            ToolState& state = states_[i];
            state.previous_pose.position += before_[i].pushed * direction(cartridges_[i], state.previous_pose);
            state.pose.position += goal_[i] * direction(cartridges_[i], state.pose);
        }
    }
}

bool ShellTools::stands(std::span<const Vec3> forces, double residual) {
    bool good = true;
    ++tries_;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        if (!pushes(i)) {
            continue;
        }
        const Cartridge& own = cartridges_[i];
        const PlungerState& before = before_[i];
        const bool lost = residual > far_from_balance && before.force > hard * own.most_force;
        const double force = lost ? HUGE_VAL : forces[i].dot(direction(own, given_[i].pose));
        if (const auto nearer = nearer_goal(own, before, goal_[i], force)) {
            const double more =
                std::isfinite(force) ? force - before.force : careful * std::max(0.0, own.most_force - before.force);
            tried_[i] = std::max(tried_[i], more / (goal_[i] - before.pushed));
            goal_[i] = tries_ < most_tries ? *nearer : before.pushed;
            good = false;
        } else {
            const bool limited = goal_[i] < given_[i].jaw * own.stroke;
            const double pressed = std::isfinite(force) ? force : before.force;
            after_[i] = pushed_plunger(before, goal_[i], pressed, limited, tried_[i]);
        }
    }
    if (!good) {
        move_plungers();
    }
    return good;
}

bool ShellTools::held_still() {
    bool still = true;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        if (pushes(i)) {
            still = still && goal_[i] == before_[i].pushed;
            goal_[i] = before_[i].pushed;
        }
    }
    after_ = before_;
    move_plungers();
    return still;
}

}  // namespace rhexis
