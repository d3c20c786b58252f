// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "flow/tool.hpp"

namespace rhexis {

/// "cannula", "capsule_hook", "cutter", "cystotome", "drape", "forceps", "hook", "hydration_cannula", "ia_tip",
/// "injector", "keratome", "lens_forceps", "needle_holder", "phaco", "probe" (a rod of 0.5 mm diameter and 30 mm
/// length), "ring", "saline_cannula", "side_port_blade", "spatula", "speculum", "sponge" or "triamcinolone". The error
/// suggests the nearest name.
Result<ToolModel> make_tool(std::string_view name);

/// All names, in alphabetical order.
std::vector<std::string> tool_names();

/// Those of the tools, and then the microscope's.
std::vector<std::string> instrument_names();

}  // namespace rhexis
