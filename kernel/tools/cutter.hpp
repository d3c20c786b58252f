// SPDX-License-Identifier: GPL-3.0-or-later
// A vitrectomy cutter for the front of the eye.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// 23 gauge: a needle of 0.64 mm with a mouth of 0.4 mm, which looks down along its shaft. Fluid comes in through a
/// sleeve around it; where it comes in makes no difference here. [mm]
ToolModel cutter();

}  // namespace rhexis
