// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: vitreous that comes forward through openings behind the lens, and what instruments do to it.
// docs/vitreous.md has the formulas.
#pragma once

#include <array>
#include <span>

#include "flow/tool.hpp"
#include "flow/world.hpp"
#include "physics/fluid/mouth.hpp"

namespace rhexis {

/// A way for the vitreous into the anterior chamber.
struct WayForward {
    Vec3 place = Vec3::Zero();  ///< its middle, in the eye's frame [mm]
    double area = 0.0;          ///< [mm^2]; 0: there is none
    double radius = 0.0;        ///< over which the hyaloid spans it [mm]
};
std::array<WayForward, opening_count> ways_forward(const WorldModel& model, const WorldState& state);

/// Before the fluid moves: what cannulas give, how vitreous shuts mouths, whether the main wound gapes. Tips have been
/// looked at. The eye's volume grows by what is injected.
void lay_viscoelastic(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                      double dt, WorldState& state);

/// How open the main wound is by what is in it and what has just left it, of what instruments and burns leave open.
double wound_release(const VitreousModel& model, const VitreousState& state, double open);

/// After the fluid has moved: the pressure behind, the hyaloid, flow through the openings and into the wound, traction,
/// and what is cut.
void move_vitreous(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                   double dt, WorldState& state);

}  // namespace rhexis
