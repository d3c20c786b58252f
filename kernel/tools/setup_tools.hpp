// SPDX-License-Identifier: GPL-3.0-or-later
// What makes the eye ready: a drape and a speculum, as a hand leads them.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// The edge of an adhesive drape between two fingers; its jaw is how hard it is pressed on, 0 to 1.
ToolModel drape();

/// A wire speculum; its jaw is how far the hand lets its spring open, 0 to 1.
ToolModel speculum();

}  // namespace rhexis
