// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: how far the plunger of an injector goes in a step. It goes where the hand wants it, no faster than a
// hand is, unless that takes more force than a hand has: then no farther than where it takes that. Where that is, is
// told from how the force has grown of late; a step that ends with too much is made again with a shorter way.
#pragma once

#include <optional>

#include "flow/tool.hpp"

namespace rhexis {

/// Where it is to go in a step of dt [s], from where it stands before it is pushed [mm].
double plunger_goal(const Cartridge& cartridge, const PlungerState& before, double wanted, double dt);

/// Where to go instead after a step that ended with this force [uN]; none where that step stands, which one in which it
/// held still or went back always does.
std::optional<double> nearer_goal(const Cartridge& cartridge, const PlungerState& before, double goal, double force);

/// After a step that stands. limited: it did not go as far as the hand wanted; tried: growth of the force with the way
/// in those that did not stand, or 0 [uN/mm].
PlungerState pushed_plunger(const PlungerState& before, double goal, double force, bool limited, double tried = 0.0);

}  // namespace rhexis
