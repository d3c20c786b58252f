// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: tissue that shuts the mouth of an aspirating tip is drawn into its bore.
//
// An elastic body that is pressed against a hole enters it beyond about ten times its Young's modulus, and the faster
// the higher the pressure. The edge of a needle that vibrates cuts it, so that less pressure does.
//
//   dV/dt = c (p / p_c - 1) for p > p_c = 10 E (1 - 0.7 P)         c = 3 mm^3/s. Proposals
//
// with E what tissue that is emulsified in part has left, and P the share of full ultrasound power. Ultrasound that
// finds no tissue around the end is spent in the bore, on what suction holds before it. What is nearest to the mouth
// goes first.
#pragma once

#include "physics/fluid/mouth.hpp"

namespace rhexis {

/// Lets one tool draw on the lens (solid 0) for dt [s]: lowers fractions, books removed mass and energy. spare_energy:
/// what sculpt left over [mJ]; state.tips must be those of this step.
void aspirate(const WorldModel& model, int tool, const ToolState& tool_state, const MouthProbe& probe,
              double spare_energy, double dt, WorldState& state);

}  // namespace rhexis
