// SPDX-License-Identifier: GPL-3.0-or-later
// Backward Euler of a thin shell: the step of ImplicitStep over movements and turns. The turns of a step count from its
// start, so that rotations of any size add up as rotations do.
#pragma once

#include <string_view>

#include "base/result.hpp"
#include "flow/shell.hpp"
#include "physics/implicit_step.hpp"
#include "physics/shell_body.hpp"

namespace rhexis {

class ShellStepper {
public:
    /// The model must outlive this. instruction_set: "" for the best of this machine, or "baseline", "avx2", "avx512":
    /// same bits, other speed. Fails on one that the machine lacks and on a model that check_shell refuses.
    static Result<ShellStepper> create(const ShellModel& model, std::string_view instruction_set = {});

    /// One step of dt [s]. gravity [mm/s^2]. next may be state.
    ImplicitReport step(const ShellState& state, const ShellLoad& load, const Vec3& gravity, double dt,
                        const ImplicitSettings& settings, ShellState& next);

    /// Forgets the kept factor.
    void drop_caches() { step_.drop_caches(); }

private:
    ShellStepper(ImplicitStep step, ShellBody& body) : step_(std::move(step)), body_(&body) {}
    void lay_out(const ShellState& state, const ShellLoad& load, const Vec3& gravity);

    ImplicitStep step_;
    ShellBody* body_;  ///< of step_
    // scratch, by points: movement and turn of each node
    std::vector<Vec3> position_;
    std::vector<Vec3> velocity_;
    std::vector<Vec3> external_;
    NodeMotion motion_;
    std::vector<RigidUnknown> no_bodies_;
};

}  // namespace rhexis
