// SPDX-License-Identifier: GPL-3.0-or-later
// What the eye feels when an occlusion of the phaco tip breaks.
#pragma once

#include "flow/chamber.hpp"

namespace rhexis::scenes {

/// What a machine is set to, as its panel says it.
struct MachineSetting {
    double bottle_cm = 90.0;
    double flow_ml_min = 30.0;
    double vacuum_mmhg = 400.0;
};

/// Irrigating and aspirating. tip_open: 1 free, 0 occluded.
ChamberControl aspirating(const MachineSetting& machine, double tip_open);

struct Surge {
    double steady = 0.0;        ///< pressure of the eye while the free tip aspirates [Pa]
    double held = 0.0;          ///< while it is occluded [Pa]
    double rise = 0.0;          ///< time from occlusion to 95 % of the vacuum it leads to [s]
    double lowest = 0.0;        ///< of the eye after the break [Pa]
    double lost = 0.0;          ///< volume of the eye from held to lowest [mm^3]
    double below_steady = 0.0;  ///< volume of the eye from steady to lowest, 0 if it does not fall below [mm^3]
    double recovery = 0.0;      ///< from the break until the eye stays within 5 % of steady [s]
};
/// The free tip aspirates until nothing moves, is held occluded until nothing moves, then opened at once.
Surge surge(const ChamberModel& model, const MachineSetting& machine);

}  // namespace rhexis::scenes
