// SPDX-License-Identifier: GPL-3.0-or-later
// Wounds as the ways of instruments into the eye: which one a shaft goes through, and how it leads a tip.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "station/hands.hpp"

namespace rhexis::station {

/// The limbus is a wall, and the wound the way through it. Outside, a tip is as high over the tunnel as it was, so that
/// it goes in when it is drawn in; inside it is free; drawn out under the wound, it is lifted first. way_out: direction
/// of the tunnel, outwards. dt [s].
void keep_to_way(const Vec3& wound, const Vec3& way_out, double dt, HandState& hand);

/// Where it shows [mm]; none: it does not.
std::optional<Vec3> landmark(const Surroundings& around, const std::string& name);

/// An instrument that works through one wound works through the other, and so it is with those that work where a wound
/// is or is to be, from outside.
std::vector<std::string> wounds_like(const std::string& wound);

/// The wound that a shaft goes through; the usual one where none shows.
std::string wound_on_shaft(const Surroundings& around, const std::string& usual, const Pose& pose);

/// Whether a tip is behind its wound, seen from outside.
bool is_behind(const Vec3& wound, const Vec3& tip);

/// And not from outside to where a wound is to be.
bool leads_inside(const std::string& wound);

}  // namespace rhexis::station
