// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a shell's step in the world, redone in smaller steps where it does not come to balance.
#pragma once

#include "flow/step_outcome.hpp"
#include "physics/shell_stepper.hpp"

namespace rhexis {

enum class ShellMotion { balanced, rough, failed };

/// rough: the finest steps did not balance either, and are kept; failed: they are not finite, and next is the state
/// without velocities. rollbacks: counts what was thrown away.
ShellMotion move_shell(ShellStepper& stepper, const ShellState& state, const Vec3& gravity, double dt, ShellState& next,
                       ShellStepReport& report, int& rollbacks);

}  // namespace rhexis
