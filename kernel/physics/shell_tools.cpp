// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell_tools.hpp"

namespace rhexis {
namespace {

/// Before it is pushed, in the injector's frame.
RoundedCone plunger(const Cartridge& cartridge) {
    const auto along = [&](double z) { return cartridge.bore.pose.to_world(Vec3(0.0, 0.0, z)); };
    const double end = cartridge.plunger_from - cartridge.plunger_radius;
    return {along(end), along(end - cartridge.stroke), cartridge.plunger_radius, cartridge.plunger_radius};
}

void push(const Cartridge& cartridge, double share, Pose& pose) {
    pose.position += pose.orientation * (cartridge.bore.pose.orientation * Vec3(0.0, 0.0, share * cartridge.stroke));
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

void ShellTools::place(std::span<const ToolState> states) {
    states_.assign(states.begin(), states.end());
    tubes_.clear();
    tube_states_.clear();
    for (std::size_t i = 0; i < states_.size(); ++i) {
        if (tools_[i].kind != ToolKind::injector || !states_[i].present) {
            continue;
        }
        tubes_.push_back(cartridges_[i].bore);
        tube_states_.push_back(states[i]);
        push(cartridges_[i], states[i].previous_jaw, states_[i].previous_pose);
        push(cartridges_[i], states[i].jaw, states_[i].pose);
    }
}

}  // namespace rhexis
