// SPDX-License-Identifier: GPL-3.0-or-later
// The phacoemulsification handpiece: a 20 G tip with a bevelled mouth, and its shaft.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// Frame: the tip's foremost point is the origin, +z runs along the shaft to the hand, the mouth is cut towards +y.
/// 20 G: 0.9 mm outer, 0.7 mm inner diameter; bevel 30 degrees. Sleeve 1.5 mm wide from 1.5 mm behind the tip,
/// handpiece from 18 mm.
///
/// Power delivered to tissue at 100 %: 600 mW. Proposal: the 125 mm^3 of a nucleus of grade 3, at 30 mJ/mm^3, cost 6 s
/// of full power that finds tissue all around the tip. Whole operations cost 6 to 8 s (20.4 s of 30 % to 13.3 s of 60
/// %) [AscrsUltrasoundTime2014]; virtual surgeons need some 20. No measurement of the power itself was found.
ToolModel phaco_tip();

}  // namespace rhexis
