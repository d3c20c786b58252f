// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: where the edge of a membrane that is drawn out too far gives way.
#pragma once

#include <vector>

#include "flow/membrane.hpp"

namespace rhexis {

/// At most one, where a millimetre of some edge of the sheet is stretched the most, if that is more than the model's
/// rupture_stretch and no tear ends within that millimetre already: into the sheet, at a right angle to the edge.
std::vector<NotchProposal> propose_notches(const MembraneModel& model, const MembraneState& state);

}  // namespace rhexis
