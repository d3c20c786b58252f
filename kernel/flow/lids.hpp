// SPDX-License-Identifier: GPL-3.0-or-later
// Lids with their lashes, what a drape covers of them, and the test of the pedal over the eye. docs/setup.md.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/types.hpp"

namespace rhexis {

/// Constant while a scene runs. The surgeon sits at the patient's head: the upper lid is the near one.
struct LidsModel {
    int per_lid = 12;          ///< places of lashes along each margin
    double half_width = 14.0;  ///< from the middle to the corners: a fissure of 28 mm [mm]. Textbook
    double shut = 4.5;         ///< from the middle to a margin, before a speculum opens the lids [mm]. Textbook: 9 mm
    double opened = 7.5;       ///< likewise, once it has [mm]. Proposal
    double height = 2.0;       ///< of the margins over the lens equator, in the middle [mm]
    double fall = 0.02;  ///< of the margins towards the corners: height lost per square of the way [1/mm]. Proposal
    double reach = 1.6;  ///< of a drape that is pressed on a margin, from its middle [mm]. Proposal
    double press = 0.5;  ///< how hard it must be pressed, 0 to 1. Proposal
    double speculum_in = 6.0;  ///< how near to the axis the tip of a speculum is between the lids [mm]. Proposal
    double air_z = 6.0;        ///< over the lens equator: a tip from there on is in the air [mm]
    double infusion_resistance = 0.0;  ///< of bottle, line and sleeve [Pa s/mm^3]
};

struct LidsState {
    double opening = 0.0;               ///< by a speculum, which stays as far open as it was, 0 to 1
    std::vector<std::uint8_t> covered;  ///< per place: the near lid from the surgeon's left, then the far one
    double drip = 0.0;                  ///< infusion that runs out of a tip in the air [mm^3/s]
    std::array<double, 3> tested{};     ///< time for which pedal 1, 2 and 3 did in the air what they are to do [s]
};

LidsState rest_state(const LidsModel& model);

/// Where the lashes of a place grow, and which way they point, across the view.
Vec3 lash_place(const LidsModel& model, double opening, int place);
Vec2 lash_way(const LidsModel& model, double opening, int place);

/// Share of the places that is covered.
double covered_share(const LidsState& state);

}  // namespace rhexis
