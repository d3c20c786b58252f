// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a shell's step in the world, redone in smaller steps where it does not come to balance; with a
// membrane that it lies in, if there is one.
#pragma once

#include <optional>

#include "flow/step_outcome.hpp"
#include "physics/shell/shell_contact.hpp"
#include "physics/shell/shell_stepper.hpp"

namespace rhexis {

enum class ShellMotion { balanced, rough, failed };

/// A membrane that the shell lies in, such as the capsular bag.
struct WallTask {
    const WorldModel& world;
    int membrane = 0;  ///< the world's number of it
    const MembraneState& state;
    std::span<const ToolState> tools;
    MembraneState& next;
    ContactSet& contacts;  ///< those of instruments with it are added
};

/// A shell and what it may touch in a step.
struct ShellTask {
    const ShellState& state;
    const ShellPartners& partners;
    const Vec3& gravity;  ///< [mm/s^2]
    double dt = 0.0;      ///< [s]
    std::optional<WallTask> wall = {};
};

/// In as many steps as it takes that neither shell nor instruments go farther in one than contact allows. rough: some
/// did not balance, because finer ones were not worth while or did not either, and are kept; failed: they are not
/// finite or took too long, and next is the state without velocities. rollbacks: counts what was thrown away.
ShellMotion move_shell(ShellStepper& stepper, ShellContacts& contacts, const ShellTask& task, ShellState& next,
                       ShellStepReport& report, int& rollbacks);

}  // namespace rhexis
