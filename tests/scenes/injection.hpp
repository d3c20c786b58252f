// SPDX-License-Identifier: GPL-3.0-or-later
// A shell that the plunger of an injector pushes along its bore, for tests and benchmarks.
#pragma once

#include "flow/shell.hpp"
#include "physics/shell/shell_contact.hpp"
#include "physics/shell/shell_motion.hpp"
#include "physics/shell/shell_stepper.hpp"
#include "physics/shell/shell_tools.hpp"

namespace rhexis::scenes {

class Injection {
public:
    /// The model must outlive this. The injector stands still, its tip at the origin, its bore along -z.
    Injection(const ShellModel& model, const ToolModel& injector, ShellState start,
              const ShellContactSettings& settings = {});

    /// One step of dt [s] in which the hand pushes to a share of the stroke.
    ShellMotion step(double jaw, double dt);
    /// What it touched in the last step: plunger and bore.
    [[nodiscard]] ShellPartners partners() const;

    ShellState state;
    PlungerState plunger;
    ShellContacts contacts;
    ShellStepReport report;  ///< of the last step; iterations of all its tries
    int tries = 0;           ///< of all steps

private:
    ShellTools tools_;
    ToolState hand_;
    ShellStepper stepper_;
};

}  // namespace rhexis::scenes
