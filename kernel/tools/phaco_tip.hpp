// SPDX-License-Identifier: GPL-3.0-or-later
// The phacoemulsification handpiece: a 20 G tip with a bevelled mouth, and its shaft.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// Frame: the tip's foremost point is the origin, +z runs along the shaft to the hand, the mouth is cut towards +y.
/// 20 G: 0.9 mm outer, 0.7 mm inner diameter; bevel 30 degrees. Sleeve 1.5 mm wide from 1.5 mm behind the tip,
/// handpiece from 18 mm.
///
/// Power delivered to tissue at 100 %: 60 mW. Proposal, not measured: with 30 mJ/mm^3 for a nucleus of grade 3 a groove
/// of 10 mm^3 takes 5 s of full power, the dissipated energy usual for that step.
ToolModel phaco_tip();

}  // namespace rhexis
