// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments that stand in for zonules.
#pragma once

#include "flow/tool.hpp"

namespace rhexis {

/// A flexible hook, whose end goes round the edge of the capsule's opening; the handle of whoever sets it is its shaft.
ToolModel capsule_hook();

/// The tube from which a capsular tension ring is fed into the bag.
ToolModel tension_ring();

}  // namespace rhexis
