// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: one step of the fluid, and what it does to what it washes around. Mouths are looked at first; with
// them open or shut the chamber's tanks advance; their pressures then hold tissue on the tips, carry what is loose
// towards them, and shift lens and iris.
#pragma once

#include <span>
#include <vector>

#include "flow/tool.hpp"
#include "flow/world.hpp"
#include "physics/fluid/mouth.hpp"

namespace rhexis {

/// What the operator's pedal and the machine ask of the chamber. One handpiece: the first present that aspirates.
ChamberControl chamber_control(const WorldModel& model, std::span<const ToolState> tools,
                               std::span<const TipState> tips, std::span<const MouthProbe> probes,
                               const WoundState& wound);

/// Advances chamber, tips, the place at which the vitreous holds the bag, and the iris. Without a chamber only looks
/// at the mouths.
void step_fluid(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes,
                double dt, WorldState& state);

/// Force of the fluid that flows into the tips on the coarse nodes of one solid, added to `forces` [uN]. The drag that
/// damps the solid (damping_mass) acts against the fluid's velocity Q / (2 pi r^2) instead of against rest, within
/// `drawn` of the mouth.
void add_drag(const WorldModel& model, const WorldState& state, int solid, std::span<const ToolState> tools,
              std::span<const MouthProbe> probes, std::vector<Vec3>& forces);

/// Radius of the sphere in which aspiration pulls [mm] [Dequidt2013 section 3].
inline constexpr double drawn = 3.0;

/// Velocity of the fluid at `place` towards a mouth that takes in `flow` [mm/s].
Vec3 inflow(const Vec3& mouth, double flow, double bore, const Vec3& place);

}  // namespace rhexis
