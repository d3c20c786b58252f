// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the needle rubs in its sleeve where the wound presses on it, and heats the wound; irrigation cools
// it.
//
//   dT/dt = h P - k_t (T - T_tissue) - k_q Q (T - T_fluid)      P: share of full power, Q: infusion
//
// h = 20 K/s: a sleeved needle under 30 g of load rose from 26 to 45 degrees in a second [Zacharias2012]. k_q: at 20
// ml/min 4 per second, so that full power keeps the wound 5 K above the fluid, as wounds under surgery, which had 23 to
// 32 degrees [Nair2017]. k_t: 0.1 per second, proposal. Collagen shrinks beyond 60 degrees, within 1 to 3 s.
#pragma once

#include "flow/chamber.hpp"

namespace rhexis {

/// One step of dt [s], implicit. power: share of full, mean over the step; infusion: [mm^3/s], 0 or more.
void heat_wound(double power, double infusion, double dt, WoundState& wound);

/// By how much a wound leaks, in units of one with an instrument in it. A burnt one gapes, with or without.
double wound_gape(const WoundState& wound, bool instrument);

}  // namespace rhexis
