// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: suction holds a piece, not a point of its surface. What ultrasound left thin before the mouth bulges
// into the bore and carries the pull on to the sound tissue behind it, so the tissue within one tetrahedron of the
// mouth is led by the tip, by each node with its mass, until the pull is more than suction holds. What the grip leaves
// of that the contacts before the mouth bear, and draw the surface to it. An impulse per substep:
//
//   J = clamp_H dt (v_tip - sum w_i v_i) / sum(w_i^2 / m_i)        w_i: mass left around node i, fading with distance
//
// Ultrasound shakes it off: there is no grip while it is on.
#pragma once

#include <span>
#include <vector>

#include "flow/world.hpp"
#include "physics/fluid/mouth.hpp"

namespace rhexis {

/// What one tip leads of a solid during a step.
struct SuctionGrip {
    int tool = 0;
    double limit = 0.0;           ///< [uN]
    std::vector<int> nodes;       ///< coarse nodes, ascending
    std::vector<double> weights;  ///< theirs, of sum 1
    Vec3 mouth = Vec3::Zero();    ///< in the tool's frame [mm]
    Vec3 last = Vec3::Zero();     ///< impulse on the solid, so far in this substep [uN s]
    Vec3 impulse = Vec3::Zero();  ///< summed over the step [uN s]
};

/// Grips of the tips that hold tissue of solid 0, the lens.
void find_grips(const WorldModel& model, const WorldState& state, std::span<const ToolState> tools,
                std::span<const MouthProbe> probes, std::vector<SuctionGrip>& grips);

/// The force of each grip in the step, as a contact at the mouth with the node that bears most.
void report_grips(const std::vector<SuctionGrip>& grips, std::span<const ToolState> tools, int solid, double dt,
                  ContactSet& contacts);

}  // namespace rhexis
