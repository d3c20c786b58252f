// SPDX-License-Identifier: GPL-3.0-or-later
// Small beads in a chamber of viscoelastic, for practice with forceps. docs/beads.md.
#pragma once

#include <vector>

#include "math/types.hpp"

namespace rhexis {

/// Constant while a scene runs. All numbers: proposals.
struct BeadsModel {
    std::vector<Vec3> start;     ///< middles of the beads before the first step [mm]
    double radius = 0.3;         ///< [mm]
    double floor = 0.0;          ///< height at which a bead comes to lie [mm]
    double sinking = 1.0;        ///< of a bead that nothing holds [mm/s]
    double grip = 0.35;          ///< from the tip to the middle of a bead that jaws close on, at most [mm]
    double slip_speed = 12.0;    ///< of the tip, from which on the drag of the viscoelastic pulls a bead out [mm/s]
    Vec3 target = Vec3::Zero();  ///< middle of the tray [mm]
    double target_radius = 1.0;  ///< of the tray [mm]
    double wall = 5.0;           ///< beads stay this near to the axis [mm]
};

struct Bead {
    Vec3 position = Vec3::Zero();  ///< of its middle [mm]
    Vec3 off = Vec3::Zero();       ///< from the tip that holds it [mm]
    int tool = -1;                 ///< that holds it; -1: none
};

struct BeadsState {
    std::vector<Bead> beads;
    int grasps = 0;  ///< so far
    int drops = 0;   ///< let go or lost beside the tray, so far
};

BeadsState rest_state(const BeadsModel& model);

/// Over or in the tray, seen from above.
bool over_tray(const BeadsModel& model, const Vec3& place);

/// Beads that lie in the tray, held by nothing.
int placed_beads(const BeadsModel& model, const BeadsState& state);

}  // namespace rhexis
