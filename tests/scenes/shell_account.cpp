// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/shell_account.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::scenes {

ShellStepEnergy ShellAccount::step(TouchingShell& shell, const ShellPartners& partners, const ShellLoad& load,
                                   const Vec3& gravity, double dt) {
    const ShellState before = shell.state;
    unbalanced += shell.step(partners, load, gravity, dt).converged ? 0 : 1;
    const ShellContactWork& work = shell.contacts.work();
    const ShellStepEnergy e = ledger_.step(before, shell.state, load, gravity, dt, work, stored_);
    stored_ = work.stored;
    for (double ShellStepEnergy::*part :
         {&ShellStepEnergy::external, &ShellStepEnergy::gain, &ShellStepEnergy::contact, &ShellStepEnergy::friction,
          &ShellStepEnergy::viscosity, &ShellStepEnergy::drag, &ShellStepEnergy::damping, &ShellStepEnergy::integrator,
          &ShellStepEnergy::renewed, &ShellStepEnergy::rest}) {
        sum.*part += e.*part;
    }
    brought += std::abs(e.external);
    worst_rest = std::max(worst_rest, std::abs(e.rest));
    least_loss = std::min(least_loss, e.integrator);
    return e;
}

}  // namespace rhexis::scenes
