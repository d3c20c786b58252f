// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a needle that presses on a membrane until it goes through.
#pragma once

#include <span>
#include <vector>

#include "flow/contact.hpp"
#include "flow/world.hpp"

namespace rhexis {

/// Needles that press on a membrane with their ends harder than it bears there, after a step with these contacts. The
/// slit runs along the tool's x axis, its cutting edge.
std::vector<PunctureProposal> propose_punctures(const WorldModel& world, int membrane, const MembraneState& state,
                                                std::span<const ToolState> tools, const ContactSet& contacts);

/// Needles that push a tear harder than it bears: at its end, where their points cut, that is a share of its toughness,
/// by its thickness; at its lip all of it.
std::vector<CutProposal> propose_cuts(const WorldModel& world, int membrane, const MembraneState& state,
                                      std::span<const ToolState> tools, const ContactSet& contacts);

}  // namespace rhexis
