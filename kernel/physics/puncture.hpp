// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: what a sharp needle does to a membrane: it goes through, and cuts on where its edge presses.
#pragma once

#include <span>
#include <vector>

#include "flow/contact.hpp"
#include "flow/step_outcome.hpp"
#include "flow/world.hpp"

namespace rhexis {

/// Needles that press on a membrane with their ends harder than it bears there, after a step with these contacts. The
/// slit runs along the tool's x axis, its cutting edge.
std::vector<PunctureProposal> propose_punctures(const WorldModel& world, int membrane, const MembraneState& state,
                                                std::span<const ToolState> tools, const ContactSet& contacts);

/// Where needles stand in the sheet with nothing of it torn: a tear goes on to there, or one begins.
void propose_cuts(const WorldModel& world, const MembraneState& state, std::span<const ToolState> tools,
                  MembraneStepReport& report);

/// Share of its toughness that the membrane keeps at each of its tips: less where a sharp edge presses close to it.
std::vector<double> cutting_at_tips(const WorldModel& world, int membrane, const MembraneState& state,
                                    const ContactSet& contacts);

}  // namespace rhexis
