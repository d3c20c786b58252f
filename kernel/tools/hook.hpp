// SPDX-License-Identifier: GPL-3.0-or-later
// A hook that turns and places an implant: a thin rod with a short bent end (Sinskey's).
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// Frame as of bent_tool(): its end, 0.5 mm long and 0.2 mm thick with a round tip, points to -z; shaft 0.3 mm thick.
ToolModel hook();

}  // namespace rhexis
