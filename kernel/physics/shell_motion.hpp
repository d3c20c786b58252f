// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a shell's step in the world, redone in smaller steps where it does not come to balance.
#pragma once

#include "flow/step_outcome.hpp"
#include "physics/shell_contact.hpp"
#include "physics/shell_stepper.hpp"

namespace rhexis {

enum class ShellMotion { balanced, rough, failed };

/// A shell and what it may touch in a step.
struct ShellTask {
    const ShellState& state;
    const ShellPartners& partners;
    const Vec3& gravity;  ///< [mm/s^2]
    double dt = 0.0;      ///< [s]
};

/// In as many steps as it takes that neither shell nor instruments go farther in one than contact allows. rough: some
/// did not balance, because finer ones were not worth while or did not either, and are kept; failed: they are not
/// finite, and next is the state without velocities. rollbacks: counts what was thrown away.
ShellMotion move_shell(ShellStepper& stepper, ShellContacts& contacts, const ShellTask& task, ShellState& next,
                       ShellStepReport& report, int& rollbacks);

}  // namespace rhexis
