// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: ultrasound at the open end of a phaco tip emulsifies the tissue that it touches.
//
// The working zone is a shell, a few tenths of a millimetre thick, around the end of the tip on the front side of its
// bevelled mouth. Power is spread evenly over the zone's volume: tissue that fills only a part of the zone takes up
// that part of it, and never more than all. A tetrahedron loses fraction in proportion to the energy it takes up, so
// how much goes per second depends neither on the step nor on the mesh.
//
//   dE = P dt min(1, touched / zone),   d fraction_i = dE w_i / (touched e_i),   touched = sum w_i V_i
//
// with w_i the share of tetrahedron i that lies in the zone and e_i its ablation energy per volume.
#pragma once

#include "flow/tool.hpp"
#include "flow/world.hpp"

namespace rhexis {

/// The working zone of a tool, in the tool's frame.
struct SculptZone {
    Vec3 mouth = Vec3::Zero();     ///< centre of the opening [mm]
    Vec3 facing = -Vec3::UnitZ();  ///< unit normal of the opening, outward
    double volume = 0.0;           ///< [mm^3]; 0: the tool cannot emulsify
};

SculptZone sculpt_zone(const ToolModel& tool);

/// How much a point counts as inside the zone, 0 to 1; in the tool's frame.
double zone_weight(const ToolModel& tool, const SculptZone& zone, const Vec3& point);

/// Lets one tool act for dt [s] on every solid: lowers fractions, books removed mass and energy. Returns the energy
/// that found no tissue in the zone [mJ].
double sculpt(const WorldModel& model, int tool, const ToolState& tool_state, const SculptZone& zone, double dt,
              WorldState& state);

}  // namespace rhexis
