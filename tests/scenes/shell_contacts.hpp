// SPDX-License-Identifier: GPL-3.0-or-later
// Shells that touch something, for tests and benchmarks.
#pragma once

#include "flow/shell.hpp"
#include "physics/shell/shell_contact.hpp"
#include "physics/shell/shell_stepper.hpp"

namespace rhexis::scenes {

/// Flat in the plane z = 0, from the origin; elastic, without Poisson's effect, so that beams' closed forms hold [mm].
ShellModel flat_strip(double length, double width, double thickness, int along, int across);

/// A square plate about the z axis.
struct Plate {
    double size;       ///< of the square [mm]
    double thickness;  ///< [mm]
    int cuts;
    double z;  ///< of its middle [mm]
};

/// Unconnected plates as one shell.
ShellModel plates(const std::vector<Plate>& list);

/// Holds every freedom of the nodes at this x [mm].
void hold_line(ShellModel& model, double x);

/// A flat strip rolled up along x about the y axis, at rest everywhere: its layers apart by `pitch`, its inner end at
/// this radius [mm].
ShellState rolled_strip(const ShellModel& model, double inner_radius, double pitch);

/// A ball or a rod along y through the origin of its frame, radius [mm].
ToolModel rod(double radius, double half_length);

/// Jaws at the origin of its frame that take what is nearer than reach [mm], with so much in all [uN].
ToolModel forceps(double reach, double hold);

/// From one place to another in a step, without turning.
ToolState moving_tool(const Vec3& from, const Vec3& to);

/// A shell that is stepped with what it may touch.
class TouchingShell {
public:
    explicit TouchingShell(const ShellModel& model, const ShellContactSettings& settings = {});

    /// One step of dt [s], of the steps' tolerance; the partners must outlive it.
    ImplicitReport step(const ShellPartners& partners, const ShellLoad& load, const Vec3& gravity, double dt);

    ShellState state;
    ShellContacts contacts;
    ShellStepper stepper;
    ImplicitSettings settings{.tolerance = 1e-4, .max_newton = 60, .newton_tolerance = 1e-7};
};

}  // namespace rhexis::scenes
