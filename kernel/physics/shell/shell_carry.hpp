// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: where a step of a shell that lies in a tube may begin its search. A hand that trembles shakes the
// tube: what went with it in the last step does not go on as it went, it goes with it in this one.
#pragma once

#include <vector>

#include "flow/shell.hpp"
#include "physics/shell/shell_contact.hpp"

namespace rhexis {

/// Velocities and spins, two per node as points of ShellBody, for a step of dt [s]: those of the state with the motion
/// as a rigid body taken out and that of the tube, or of what pushes in it and touches the shell, put in. Empty where
/// the greater part of the shell lies in no tube.
std::vector<Vec3> carried_velocity(const ShellState& state, const ShellPartners& partners, double dt);

/// Whether the greater part of a shell lies in a tube that something in this pose carries.
bool lies_in(const TubeModel& tube, const Pose& carrier, const ShellState& state);

/// Whether it comes nowhere near the end of the tube: nothing outside can touch it in a step.
bool is_shut_in(const TubeModel& tube, const Pose& carrier, const ShellState& state);

/// A shell that leaves the eye in a tube: loaded, at rest, in the frame of what carries it, free of all it touched.
ShellState taken_along(const ShellState& state, const Pose& carrier);

}  // namespace rhexis
