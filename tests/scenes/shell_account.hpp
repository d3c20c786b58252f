// SPDX-License-Identifier: GPL-3.0-or-later
// Where the energy of a touching shell goes over many steps.
#pragma once

#include "physics/shell/shell_energy.hpp"
#include "scenes/shell_contacts.hpp"

namespace rhexis::scenes {

/// Its contacts must be with accounts.
class ShellAccount {
public:
    explicit ShellAccount(const ShellModel& model) : ledger_(model) {}

    /// One step of the shell, and what it did.
    ShellStepEnergy step(TouchingShell& shell, const ShellPartners& partners, const ShellLoad& load,
                         const Vec3& gravity, double dt);

    ShellStepEnergy sum;      ///< of all steps
    double brought = 0.0;     ///< external of all steps, without its sign [nJ]
    double worst_rest = 0.0;  ///< of a step, without its sign [nJ]
    double least_loss = 0.0;  ///< of backward Euler in a step: below zero it gave energy [nJ]
    int unbalanced = 0;       ///< steps

private:
    ShellLedger ledger_;
    double stored_ = 0.0;
};

}  // namespace rhexis::scenes
