// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: where a step of a shell that lies in a tube may begin its search. A hand that trembles shakes the
// tube: what went with it in the last step does not go on as it went, it goes with it in this one.
#pragma once

#include <vector>

#include "flow/shell.hpp"
#include "physics/shell_contact.hpp"

namespace rhexis {

/// Velocities and spins, two per node as points of ShellBody, for a step of dt [s]: those of the state with the motion
/// as a rigid body taken out and that of the tube, or of what pushes in it and touches the shell, put in. Empty where
/// the greater part of the shell lies in no tube.
std::vector<Vec3> carried_velocity(const ShellState& state, const ShellPartners& partners, double dt);

}  // namespace rhexis
